package org.robotui.recording;

import java.time.Duration;

/**
 * How a recording is written.
 *
 * @param compression of chunks
 * @param chunkBytes from which size on a chunk is written, before compression, 1 to 64 MiB; larger messages have a
 * chunk of their own
 * @param chunkTime after which time a chunk is written at the latest, by the clock of this machine: as much is lost
 * when the process is killed
 * @param profile what the messages are by the specification of MCAP: {@code ros1}, {@code ros2}; empty for several or
 * others
 */
public record WriterOptions(ChunkCompression compression, int chunkBytes, Duration chunkTime, String profile) {

  private static final int MOST_CHUNK_BYTES = 64 << 20;

  /** As the components say. */
  public WriterOptions {
    if (chunkBytes < 1 || chunkBytes > MOST_CHUNK_BYTES) {
      throw new IllegalArgumentException(
          "chunks of " + chunkBytes + " bytes: from 1 to " + MOST_CHUNK_BYTES + " is possible");
    }
    if (chunkTime.isNegative() || chunkTime.isZero()) {
      throw new IllegalArgumentException("chunks of " + chunkTime + ": the time must be above 0");
    }
  }

  /**
   * For most: zstd, 1 MiB, at the latest after 800 ms.
   *
   * @return these
   */
  public static WriterOptions defaults() {
    return new WriterOptions(ChunkCompression.ZSTD, 1 << 20, Duration.ofMillis(800), "");
  }

  /**
   * With another compression.
   *
   * @param other the compression
   * @return otherwise as these
   */
  public WriterOptions withCompression(ChunkCompression other) {
    return new WriterOptions(other, chunkBytes, chunkTime, profile);
  }

  /**
   * With smaller or larger chunks.
   *
   * @param bytes before compression
   * @return otherwise as these
   */
  public WriterOptions withChunkBytes(int bytes) {
    return new WriterOptions(compression, bytes, chunkTime, profile);
  }

  /**
   * With chunks that are written sooner or later.
   *
   * @param time by the clock of this machine
   * @return otherwise as these
   */
  public WriterOptions withChunkTime(Duration time) {
    return new WriterOptions(compression, chunkBytes, time, profile);
  }

  /**
   * With another profile.
   *
   * @param word of the specification of MCAP
   * @return otherwise as these
   */
  public WriterOptions withProfile(String word) {
    return new WriterOptions(compression, chunkBytes, chunkTime, word);
  }
}
