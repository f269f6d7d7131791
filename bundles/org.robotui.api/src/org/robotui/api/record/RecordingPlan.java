package org.robotui.api.record;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * How a recording is to be made.
 *
 * @param target the file, which must not be there yet; or a folder that is there, in which a file is named by the time
 * @param choice what is recorded
 * @param packing how it is made smaller
 * @param splitBytes from which size on the next file is begun, at least 1 MiB: {@code run_0001.mcap} and so on
 * @param splitTime after which time the next file is begun, at least a second
 */
public record RecordingPlan(Path target, RecordingChoice choice, RecordingPacking packing, OptionalLong splitBytes,
    Optional<Duration> splitTime) {
  /** The smallest size of which files may be. */
  public static final long LEAST_SPLIT_BYTES = 1 << 20;
  /** The shortest time of which files may be. */
  public static final Duration LEAST_SPLIT_TIME = Duration.ofSeconds(1);

  /**
   * Checks the bounds.
   *
   * @param target the file or folder
   * @param choice what is recorded
   * @param packing how it is made smaller
   * @param splitBytes from which size on
   * @param splitTime after which time
   * @throws IllegalArgumentException where files would be smaller than they may be
   */
  public RecordingPlan {
    if (splitBytes.orElse(LEAST_SPLIT_BYTES) < LEAST_SPLIT_BYTES) {
      throw new IllegalArgumentException("files of " + splitBytes.getAsLong() + " bytes are too small; at least "
          + LEAST_SPLIT_BYTES + " are possible");
    }
    if (splitTime.orElse(LEAST_SPLIT_TIME).compareTo(LEAST_SPLIT_TIME) < 0) {
      throw new IllegalArgumentException("files of " + splitTime.get() + " are too short; at least one second is "
          + "possible");
    }
  }

  /**
   * All that all robots send, in one file, by zstd.
   *
   * @param target the file or folder
   * @return the plan
   */
  public static RecordingPlan of(Path target) {
    return new RecordingPlan(target, RecordingChoice.ALL, RecordingPacking.ZSTD, OptionalLong.empty(),
        Optional.empty());
  }

  /**
   * With another choice.
   *
   * @param other what is recorded
   * @return otherwise as this
   */
  public RecordingPlan choosing(RecordingChoice other) {
    return new RecordingPlan(target, other, packing, splitBytes, splitTime);
  }

  /**
   * Whether there may be several files.
   *
   * @return true where size or time is bounded
   */
  public boolean splits() {
    return splitBytes.isPresent() || splitTime.isPresent();
  }
}
