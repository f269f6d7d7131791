package org.robotui.workbench.internal;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robotui.api.input.Numerals;
import org.robotui.ui.Themes;

/**
 * What the command line asks of the workbench. Words that it does not know are the platform's.
 *
 * @param configurations the files to load
 * @param files recordings and the like, which are opened as robots
 * @param limit after which time to close
 * @param screenshot where to save a picture of the window
 * @param after how long to wait with the picture
 * @param theme how to look, this time
 * @param measure where to write how the window did
 * @param script a script to run once the configurations are read
 * @param scriptSocket whether other programs of this user may run scripts
 */
public record Arguments(List<Path> configurations, List<Path> files, Optional<Duration> limit,
    Optional<Path> screenshot, Duration after,
    Optional<String> theme, Optional<Path> measure, Optional<Path> script, boolean scriptSocket) {
  private static final double MOST_SECONDS = 1e6;
  private static final Duration USUAL_AFTER = Duration.ofSeconds(3);

  /**
   * Reads the command line.
   *
   * @param words the words
   * @return what they ask
   * @throws IllegalArgumentException with a sentence for users
   */
  public static Arguments parse(String... words) {
    return new Parser(words).parse();
  }

  /**
   * Whether somebody may be expected to answer questions.
   *
   * @return false where the workbench makes a picture or closes by itself
   */
  public boolean isAttended() {
    return limit.isEmpty() && screenshot.isEmpty();
  }

  /** Reads the words one after the other. */
  private static final class Parser {
    private final List<String> words;
    private final List<Path> configurations = new ArrayList<>();
    private final List<Path> files = new ArrayList<>();
    private Optional<Duration> limit = Optional.empty();
    private Optional<Path> screenshot = Optional.empty();
    private Duration after = USUAL_AFTER;
    private Optional<String> theme = Optional.empty();
    private Optional<Path> measure = Optional.empty();
    private Optional<Path> script = Optional.empty();
    private boolean scriptSocket;
    private int at;

    Parser(String... words) {
      this.words = Arrays.asList(words);
    }

    Arguments parse() {
      while (at < words.size()) {
        option(words.get(at++));
      }
      return new Arguments(List.copyOf(configurations), List.copyOf(files), limit, screenshot, after, theme, measure,
          script,
          scriptSocket);
    }

    private void option(String word) {
      switch (word) {
        case "-config" -> paths(word, configurations);
        case "-open" -> paths(word, files);
        case "-for" -> limit = Optional.of(seconds(word));
        case "-after" -> after = seconds(word);
        case "-screenshot" -> screenshot = Optional.of(Path.of(value(word)));
        case "-measure" -> measure = Optional.of(Path.of(value(word)));
        case "-script" -> script = Optional.of(Path.of(value(word)));
        case "-scriptsocket" -> scriptSocket = true;
        case "-theme" -> theme = Optional.of(theme(value(word)));
        default -> {}
      }
    }

    private void paths(String option, List<Path> named) {
      named.add(Path.of(value(option)));
      while (at < words.size() && !words.get(at).startsWith("-")) {
        named.add(Path.of(words.get(at++)));
      }
    }

    private static String theme(String word) {
      if (!Themes.ids().contains(word)) {
        throw new IllegalArgumentException("-theme is " + String.join(" or ", Themes.ids()) + ", not '" + word + "'");
      }
      return word;
    }

    private String value(String option) {
      if (at == words.size() || words.get(at).startsWith("-")) {
        throw new IllegalArgumentException(option + " needs a value");
      }
      return words.get(at++);
    }

    private Duration seconds(String option) {
      String text = value(option);
      return Numerals.decimal(text).filter(seconds -> seconds >= 0 && seconds <= MOST_SECONDS)
          .map(seconds -> Duration.ofMillis(Math.round(seconds * 1e3)))
          .orElseThrow(() -> new IllegalArgumentException(
              option + " needs a number of seconds from 0 to " + Numerals.text(MOST_SECONDS) + ", not '" + text + "'"));
    }
  }
}
