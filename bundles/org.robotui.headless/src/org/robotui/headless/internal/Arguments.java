package org.robotui.headless.internal;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.input.Numerals;

/**
 * What the command line asks for.
 *
 * @param configurations the files to load
 * @param files recordings and the like, which are opened as robots
 * @param json true for JSON lines, else text
 * @param limit how long to run
 * @param check a file to check only
 * @param live how long to wait for the robots of the checked file; none to ask no robot
 * @param reuse with a check: print the matrix of what is used by which RUIC, {@code md} or {@code csv}
 * @param shown names of RUICs that are shown though they start only when they are shown
 * @param watch true to take up what is changed in the files
 * @param script a script to run in place of showing anything
 * @param scriptSocket true to let other programs run scripts
 */
record Arguments(
    List<Path> configurations, List<Path> files, boolean json, Optional<Duration> limit, Optional<Path> check,
    Optional<Duration> live,
    Set<String> shown,
    boolean watch, Optional<String> reuse, Optional<Path> script, boolean scriptSocket) {
  static final String USAGE = """
      -config FILE...   load these configurations
      -open FILE...     open these recordings as robots; see docs/recordings.md
      -json             print a JSON line per port and second in place of the text views
      -for SECONDS      end by itself
      -show NAME        also show this robot UI, which starts only when it is shown; may be given several times
      -script FILE      run this script in place of showing anything, and end with it; see docs/scripting.md
      -scriptsocket     let other programs of this user run scripts, until the end
      -watch            take up what is changed in the files while they run; see docs/exchange.md
      -check FILE       check a configuration and print what would be connected
      -live SECONDS     with -check: connect to the robots, and wait at most so long for what they have
      -reuse md|csv     with -check: print which bundles are used by which robot UI
      exit codes: 0 fine, 1 errors in a configuration, 2 a file cannot be read, 3 wrong arguments, 4 the core did not start,
        5 the script failed or was stopped; what a script gives to exit() is the code itself
      """;

  private static final double MOST_SECONDS = 1e9;

  /** Whether something must be there that runs scripts. */
  boolean usesScripts() {
    return scriptSocket || script.isPresent();
  }

  /** Wrong arguments, with a sentence for users. */
  static final class Wrong extends Exception {
    private static final long serialVersionUID = 1L;

    Wrong(String message) {
      super(message);
    }
  }

  static Arguments parse(String[] words) throws Wrong {
    return new Parser(words).parse();
  }

  /** Reads the words one after the other. */
  private static final class Parser {
    private final List<String> words;
    private final List<Path> configurations = new ArrayList<>();
    private final List<Path> files = new ArrayList<>();
    private final Set<String> shown = new LinkedHashSet<>();
    private boolean json;
    private boolean watch;
    private boolean scriptSocket;
    private Optional<Path> script = Optional.empty();
    private Optional<String> reuse = Optional.empty();
    private Optional<Duration> limit = Optional.empty();
    private Optional<Path> check = Optional.empty();
    private Optional<Duration> live = Optional.empty();
    private int at;

    Parser(String[] words) {
      this.words = Arrays.asList(words);
    }

    Arguments parse() throws Wrong {
      while (at < words.size()) {
        option(words.get(at++));
      }
      return new Arguments(List.copyOf(configurations), List.copyOf(files), json, limit, check, live, Set.copyOf(shown),
          watch, reuse,
          script, scriptSocket);
    }

    private void option(String word) throws Wrong {
      switch (word) {
        case "-config" -> paths(word, configurations);
        case "-open" -> paths(word, files);
        case "-json" -> json = true;
        case "-reuse" -> reuse = Optional.of(oneOf(word, List.of("md", "csv")));
        case "-show" -> shown.add(value(word));
        case "-watch" -> watch = true;
        case "-script" -> script = Optional.of(Path.of(value(word)));
        case "-scriptsocket" -> scriptSocket = true;
        case "-for" -> limit = Optional.of(seconds(word, value(word)));
        case "-live" -> live = Optional.of(seconds(word, value(word)));
        case "-check" -> check = Optional.of(Path.of(value(word)));
        default -> throw new Wrong("unknown argument " + word);
      }
    }

    private void paths(String option, List<Path> named) throws Wrong {
      named.add(Path.of(value(option)));
      while (at < words.size() && !words.get(at).startsWith("-")) {
        named.add(Path.of(words.get(at++)));
      }
    }

    private String value(String option) throws Wrong {
      if (at == words.size() || words.get(at).startsWith("-")) {
        throw new Wrong(option + " needs a value");
      }
      return words.get(at++);
    }

    private String oneOf(String option, List<String> words) throws Wrong {
      String value = value(option);
      if (!words.contains(value)) {
        throw new Wrong(option + " is " + String.join(" or ", words) + ", not '" + value + "'");
      }
      return value;
    }

    private static Duration seconds(String option, String text) throws Wrong {
      return Numerals.decimal(text).filter(seconds -> seconds >= 0 && seconds <= MOST_SECONDS)
          .map(seconds -> Duration.ofNanos(Math.round(seconds * 1e9))).orElseThrow(() -> new Wrong(
              option + " needs a number of seconds from 0 to " + Numerals.text(MOST_SECONDS) + ", not '" + text + "'"));
    }
  }
}
