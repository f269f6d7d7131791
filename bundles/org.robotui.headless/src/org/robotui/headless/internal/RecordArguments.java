package org.robotui.headless.internal;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.api.input.Numerals;
import org.robotui.api.record.RecordingChoice;
import org.robotui.api.record.RecordingPacking;
import org.robotui.api.record.RecordingPlan;

/**
 * What is to be recorded.
 *
 * @param plan how
 * @param rest everything else that was said
 */
record RecordArguments(RecordingPlan plan, Arguments rest) {
  static final String OPTION = "-record";
  static final String USAGE = """
      -record PLACE     record what the robots send to this file, or to a new file in this folder, until the end
      -robots NAME      only these robots; * and ? stand for any letters; may be given several times, as -ports NAME
      -compression none|lz4|zstd  -splitsize BYTES  -splittime SECONDS
      exit code 6: the recording could not be begun, or ended by itself
      """;

  /** Wrong arguments, with a sentence for users, are those of {@link Arguments}. */
  static RecordArguments parse(List<String> words) throws Arguments.Wrong {
    return new Parser(words).parse();
  }

  private static final class Parser {
    private final List<String> words;
    private final List<String> rest = new ArrayList<>();
    private final List<String> robots = new ArrayList<>();
    private final List<String> ports = new ArrayList<>();
    private Path target = Path.of(".");
    private RecordingPacking packing = RecordingPacking.ZSTD;
    private OptionalLong splitBytes = OptionalLong.empty();
    private Optional<Duration> splitTime = Optional.empty();
    private int at;

    Parser(List<String> words) {
      this.words = words;
    }

    RecordArguments parse() throws Arguments.Wrong {
      while (at < words.size()) {
        option(words.get(at++));
      }
      Arguments others = Arguments.parse(rest.toArray(String[]::new));
      try {
        return new RecordArguments(
            new RecordingPlan(target, new RecordingChoice(robots, ports), packing, splitBytes, splitTime), others);
      } catch (IllegalArgumentException e) {
        throw new Arguments.Wrong(e.getMessage());
      }
    }

    private void option(String word) throws Arguments.Wrong {
      switch (word) {
        case OPTION -> target = Path.of(value(word));
        case "-robots" -> robots.add(value(word));
        case "-ports" -> ports.add(value(word));
        case "-compression" -> packing = packing(value(word));
        case "-splitsize" -> splitBytes = OptionalLong.of(Math.round(number(word)));
        case "-splittime" -> splitTime = Optional.of(Duration.ofMillis(Math.round(number(word) * 1000)));
        default -> rest.add(word);
      }
    }

    private String value(String option) throws Arguments.Wrong {
      if (at == words.size()) {
        throw new Arguments.Wrong(option + " needs a value");
      }
      return words.get(at++);
    }

    private double number(String option) throws Arguments.Wrong {
      String text = value(option);
      return Numerals.decimal(text).filter(number -> number > 0 && number <= 1e15)
          .orElseThrow(() -> new Arguments.Wrong(option + " needs a number above 0, not '" + text + "'"));
    }

    private static RecordingPacking packing(String word) throws Arguments.Wrong {
      try {
        return RecordingPacking.valueOf(word.toUpperCase(Locale.ROOT));
      } catch (IllegalArgumentException e) {
        throw new Arguments.Wrong("-compression is none, lz4 or zstd, not '" + word + "'");
      }
    }
  }
}
