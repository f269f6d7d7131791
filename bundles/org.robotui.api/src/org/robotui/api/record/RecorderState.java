package org.robotui.api.record;

import java.time.Duration;
import java.util.Optional;

/**
 * What the recorder does, at one moment.
 *
 * @param recording the one that is being made
 * @param ended how the one before ended; none before the first
 * @param recent what is kept of the last seconds, where that is switched on
 */
public record RecorderState(Optional<RecordingStatus> recording, Optional<Ended> ended, Optional<Recent> recent) {
  /**
   * A recording that was ended.
   *
   * @param status as it was at its end
   * @param reason why it ended by itself, such as a full disk; empty where somebody ended it
   */
  public record Ended(RecordingStatus status, String reason) {}

  /**
   * The last seconds, in memory.
   *
   * @param limit how long messages are kept
   * @param kept how far back they go now
   * @param bytes what they take
   * @param messages how many they are
   * @param cut whether they go back less far than they should, as they would take too much memory
   */
  public record Recent(Duration limit, Duration kept, long bytes, long messages, boolean cut) {}
}
