package org.robotui.rfic.recording.internal.session;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Locale;
import org.robotui.api.replay.TimeRange;

/** Recordings in words, for users. */
final class RecordingWords {
  private RecordingWords() {}

  /** Such as {@code run.mcap, 3 min 20 s, 12 topics}. */
  static String of(Path file, TimeRange span, int topics) {
    return file.getFileName() + ", " + length(Duration.ofNanos(span.length())) + ", " + topics
        + (topics == 1 ? " topic" : " topics");
  }

  private static String length(Duration length) {
    if (length.toHours() > 0) {
      return length.toHours() + " h " + length.toMinutesPart() + " min";
    }
    return length.toMinutes() > 0 ? length.toMinutes() + " min " + length.toSecondsPart() + " s"
        : number(length.toNanos() / 1e9) + " s";
  }

  static String number(double number) {
    return String.format(Locale.ROOT, number < 10 ? "%.1f" : "%.0f", number);
  }
}
