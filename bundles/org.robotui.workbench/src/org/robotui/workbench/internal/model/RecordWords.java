package org.robotui.workbench.internal.model;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import org.robotui.api.record.RecorderState;
import org.robotui.api.record.RecordingStatus;

/**
 * What the record button says.
 *
 * @param on whether it records
 * @param text on the button
 * @param hint about it
 */
public record RecordWords(boolean on, String text, String hint) {
  private static final long GIGA = 1L << 30;

  /** Where nothing is recorded, and nothing was. */
  public static final RecordWords IDLE = new RecordWords(false, "Record", "Record what the robots send");

  /** Of a recorder, at a moment. */
  public static RecordWords of(RecorderState state, Instant now) {
    return state.recording().map(status -> running(status, now))
        .orElseGet(() -> state.ended().filter(ended -> !ended.reason().isEmpty())
            .map(ended -> new RecordWords(false, IDLE.text(), "The recording has ended: " + ended.reason()))
            .orElse(state.recent().map(recent -> new RecordWords(false, IDLE.text(),
                IDLE.hint() + "; the last " + recent.kept().toSeconds() + " s are kept")).orElse(IDLE)));
  }

  private static RecordWords running(RecordingStatus status, Instant now) {
    Path file = status.file();
    String problems = status.problems().isEmpty() ? "" : "\n" + String.join("\n", status.problems());
    return new RecordWords(true, time(Duration.between(status.since(), now)) + "   " + size(status.bytes()),
        "Recording to " + file + "\n" + size(status.diskLeft()) + " left on the disk" + left(status) + problems);
  }

  private static String left(RecordingStatus status) {
    return status.leftOut().isEmpty() ? ""
        : "\nNot recorded, as it is on request alone: " + String.join(", ", status.leftOut());
  }

  /** Minutes and seconds, as clocks of players have them. */
  static String time(Duration since) {
    long seconds = Math.max(0, since.toSeconds());
    return seconds < 3600 ? String.format(Locale.ROOT, "%d:%02d", seconds / 60, seconds % 60)
        : String.format(Locale.ROOT, "%d:%02d:%02d", seconds / 3600, seconds / 60 % 60, seconds % 60);
  }

  static String size(long bytes) {
    return bytes >= GIGA ? String.format(Locale.ROOT, "%.1f GB", bytes / (double) GIGA)
        : String.format(Locale.ROOT, "%.1f MB", bytes / (double) (1 << 20));
  }
}
