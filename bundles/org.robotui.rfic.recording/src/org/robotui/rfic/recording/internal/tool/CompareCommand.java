package org.robotui.rfic.recording.internal.tool;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.condition.TimedCondition;
import org.robotui.rfic.recording.internal.compare.CompareWish;
import org.robotui.rfic.recording.internal.compare.CompareWish.Pairing;
import org.robotui.rfic.recording.internal.compare.ComparedTopic;
import org.robotui.rfic.recording.internal.compare.PoseFit;
import org.robotui.rfic.recording.internal.compare.RelativeStep;

/**
 * What was asked of {@code log compare}.
 *
 * @param first the recording with which the other one is compared
 * @param second the other one
 * @param wishes how, for each topic
 * @param json whether it is said to a program
 * @param csv where the errors are written
 * @param begin of the part that is compared
 * @param end of it
 * @param types where types of LCM are declared
 */
record CompareCommand(Path first, Path second, List<CompareWish> wishes, boolean json, Optional<Path> csv,
    Optional<LogTime> begin, Optional<LogTime> end, List<Path> types) {
  static final String VERB = "compare";
  private static final double FARTHEST_SECONDS = 4e9;
  private static final double NANOS = 1e9;

  /** The words behind the verb. */
  static CompareCommand of(List<String> arguments) throws UsageException {
    LogOptions words = new LogOptions(VERB, arguments);
    boolean json = words.flag("--json");
    Optional<Path> csv = words.value("--csv").map(Path::of);
    Optional<LogTime> begin = words.time("--from");
    Optional<LogTime> end = words.time("--to");
    List<Path> types = words.paths("--types");
    List<CompareWish> wishes = wishes(words);
    List<Path> files = words.files();
    if (files.size() != 2) {
      throw new UsageException("log compare takes two files");
    }
    if (wishes.isEmpty()) {
      throw new UsageException("log compare needs --topic and what is compared: a topic that says where something is,"
          + " such as --topic odom, or a number, such as --topic \"odom linear.x\"");
    }
    if (csv.isPresent() && wishes.size() > 1) {
      throw new UsageException("--csv takes the errors of one --topic");
    }
    return new CompareCommand(files.getFirst(), files.getLast(), wishes, json, csv, begin, end, types);
  }

  private static List<CompareWish> wishes(LogOptions words) throws UsageException {
    try {
      Pairing pairing = pairing(words);
      PoseFit fit = fit(words.value("--align"));
      RelativeStep step = words.value("--rpe").map(RelativeStep::of).orElse(RelativeStep.POSE);
      long apart = words.number("--max-diff", 0, FARTHEST_SECONDS).map(CompareCommand::nanos)
          .orElse(CompareWish.MOST_APART);
      long offset = words.number("--offset", -FARTHEST_SECONDS, FARTHEST_SECONDS).map(CompareCommand::nanos).orElse(0L);
      List<CompareWish> wishes = new ArrayList<>();
      for (String topic : words.values("--topic")) {
        wishes.add(new CompareWish(ComparedTopic.of(topic), pairing, fit, step, apart, offset));
      }
      return wishes;
    } catch (IllegalArgumentException e) {
      throw new UsageException(e.getMessage());
    }
  }

  private static long nanos(double seconds) {
    return Math.round(seconds * NANOS);
  }

  private static Pairing pairing(LogOptions words) throws UsageException {
    Optional<String> event = words.value("--event");
    Optional<ComparedTopic> way = words.value("--way").map(ComparedTopic::of);
    event.ifPresent(text -> TimedCondition.parse(text, 0));
    Pairing pairing =
        switch (words.value("--by").orElse(event.isPresent() ? "event" : way.isPresent() ? "way" : "time")) {
          case "time" -> new Pairing.Clock();
          case "start" -> new Pairing.Start();
          case "way" -> new Pairing.Gone(way);
          case "event" -> new Pairing.Event(event.orElseThrow(
              () -> new UsageException("--by event needs --event and a condition, such as --event \"age(scan) > 1\"")));
          default -> throw new UsageException("--by takes time, start, event or way");
        };
    if (event.isPresent() && !(pairing instanceof Pairing.Event) || way.isPresent()
        && !(pairing instanceof Pairing.Gone)) {
      throw new UsageException("--event goes with --by event, --way with --by way");
    }
    return pairing;
  }

  private static PoseFit fit(Optional<String> word) throws UsageException {
    return word.isEmpty() ? PoseFit.NONE
        : Arrays.stream(PoseFit.values()).filter(each -> each.word().equals(word.get())).findFirst()
            .orElseThrow(() -> new UsageException("--align takes "
                + Arrays.stream(PoseFit.values()).map(PoseFit::word).collect(Collectors.joining(", ")) + ", not '"
                + word.get() + "'"));
  }
}
