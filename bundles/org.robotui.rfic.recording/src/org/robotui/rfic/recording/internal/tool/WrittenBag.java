package org.robotui.rfic.recording.internal.tool;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingCopy;
import org.robotui.recording.RecordingPart;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.WriterOptions;
import org.robotui.rfic.recording.internal.file.Ros1Types;

/** Writes what is of ROS 1 in recordings as a bag, and says what is left out. */
final class WrittenBag {
  private final PrintStream out;

  WrittenBag(PrintStream out) {
    this.out = out;
  }

  /** Whether a bag is asked for. */
  static boolean isAsked(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".bag");
  }

  RecordingCopy.Outcome write(List<RecordingReader> from, RecordingPart part, Path to, WriterOptions options)
      throws IOException, UsageException {
    List<RecordedChannel> chosen =
        from.stream().flatMap(each -> each.channels().stream()).filter(part.channels()).toList();
    List<RecordedChannel> fit = chosen.stream().filter(RecordingCopy::fitsBag).toList();
    if (fit.isEmpty()) {
      throw new UsageException("a bag has messages of ROS 1, and there are none: name a file that ends with .mcap");
    }
    Map<RecordedSchema, String> sums = new HashMap<>();
    for (RecordedChannel each : fit) {
      sums.put(each.schema(), Ros1Types.of(each).md5());
    }
    RecordingCopy.Outcome outcome = RecordingCopy.toBag(from,
        new RecordingPart(part.interval(), part.channels().and(RecordingCopy::fitsBag)), to, options,
        channel -> channel.metadata().getOrDefault("md5sum", sums.get(channel.schema())));
    if (fit.size() < chosen.size()) {
      out.println("left out, as a bag has messages of ROS 1 alone: "
          + chosen.stream().filter(each -> !RecordingCopy.fitsBag(each)).map(RecordedChannel::topic).distinct()
              .sorted().collect(Collectors.joining(", ")));
    }
    return outcome;
  }
}
