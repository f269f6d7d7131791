package org.robotui.lcm.log;

import java.nio.ByteBuffer;

/**
 * One message of a log.
 *
 * @param number its number as the log says, from 0
 * @param utime when it was received, microseconds since 1970
 * @param channel the channel
 * @param data its bytes, read-only and big-endian
 * @param offset where it starts in the file
 */
public record LogEvent(long number, long utime, String channel, ByteBuffer data, long offset) {

  /** Sees to it that nobody can change the bytes. */
  public LogEvent {
    data = data.slice().asReadOnlyBuffer();
  }

  /**
   * The bytes.
   *
   * @return a view of its own for each call
   */
  @Override
  public ByteBuffer data() {
    return data.duplicate();
  }
}
