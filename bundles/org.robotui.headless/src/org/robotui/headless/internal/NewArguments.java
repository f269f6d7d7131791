package org.robotui.headless.internal;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.input.Numerals;
import org.robotui.headless.internal.Arguments.Wrong;

/**
 * What the command line wants for a robot.
 *
 * @param file where it is written
 * @param rfic the type of robot interface
 * @param settings of the robot interface
 * @param name of the RUIC
 * @param robot its name, where it is another than that of the RUIC
 * @param ruic the type of RUIC; none for the best
 * @param views types of views; none for those that fit
 * @param connections port of a view to port of the robot interface
 * @param patience how long to wait for the robot
 * @param dry true to print what would be written, and write nothing
 */
record NewArguments(Path file, String rfic, Map<String, String> settings, String name, String robot,
    Optional<String> ruic,
    Optional<List<String>> views, Map<String, String> connections, Duration patience, boolean dry) {
  static final String USAGE = """
      -new FILE -rfic TYPE -called NAME [OPTION...]   write the configuration of a robot from what it offers; FILE is new, or is added to
        -set KEY=VALUE       a setting of the robot interface, such as host=localhost; any number of them
        -ruic TYPE           the type of robot UI; else the one that covers best what is offered
        -views A,B,...       the views; else those of the type that fit
        -connect VIEW.PORT=PORT   where several ports fit; else the one with the shortest name
        -robot NAME          name of the robot, where it is not that of the robot UI
        -wait SECONDS        how long to wait for the robot (15)
        -dry                 print it, and write nothing
      """;
  private static final Duration WAIT = Duration.ofSeconds(15);

  static NewArguments parse(List<String> words) throws Wrong {
    Map<String, String> one = new LinkedHashMap<>();
    Map<String, String> settings = new LinkedHashMap<>();
    Map<String, String> connections = new LinkedHashMap<>();
    boolean dry = false;
    for (int at = 0; at < words.size(); at++) {
      String word = words.get(at);
      switch (word) {
        case "-dry" -> dry = true;
        case "-set" -> pair(settings, word, value(words, ++at, word));
        case "-connect" -> pair(connections, word, value(words, ++at, word));
        case "-new", "-rfic", "-called", "-robot", "-ruic", "-views",
            "-wait" -> one.put(word, value(words, ++at, word));
        default -> throw new Wrong("unknown argument " + word);
      }
    }
    return new NewArguments(Path.of(needed(one, "-new", "FILE")), needed(one, "-rfic", "TYPE"), settings,
        needed(one, "-called", "NAME"),
        one.getOrDefault("-robot", ""), Optional.ofNullable(one.get("-ruic")),
        Optional.ofNullable(one.get("-views")).map(NewArguments::list),
        connections, one.containsKey("-wait") ? seconds(one.get("-wait")) : WAIT, dry);
  }

  private static String value(List<String> words, int at, String option) throws Wrong {
    if (at >= words.size()) {
      throw new Wrong(option + " needs a value");
    }
    return words.get(at);
  }

  private static void pair(Map<String, String> pairs, String option, String text) throws Wrong {
    int equals = text.indexOf('=');
    if (equals <= 0) {
      throw new Wrong(option + " needs a name and a value, such as "
          + ("-set".equals(option) ? "host=localhost" : "camera.image=image_raw")
          + ", not '" + text + "'");
    }
    pairs.put(text.substring(0, equals).strip(), text.substring(equals + 1).strip());
  }

  private static String needed(Map<String, String> given, String option, String what) throws Wrong {
    if (!given.containsKey(option)) {
      throw new Wrong(option + " " + what + " is missing");
    }
    return given.get(option);
  }

  private static List<String> list(String text) {
    List<String> all = new ArrayList<>();
    for (String word : text.split(",")) {
      if (!word.isBlank()) {
        all.add(word.strip());
      }
    }
    return List.copyOf(all);
  }

  private static Duration seconds(String text) throws Wrong {
    return Numerals.decimal(text).filter(seconds -> seconds > 0 && seconds <= 3600)
        .map(seconds -> Duration.ofMillis(Math.round(seconds * 1e3)))
        .orElseThrow(() -> new Wrong("-wait needs a number of seconds up to 3600, not '" + text + "'"));
  }
}
