package org.robotui.lcm;

import java.nio.ByteBuffer;

/**
 * A message as it came.
 *
 * @param channel the channel
 * @param data its bytes, read-only and big-endian; they stay as they are
 * @param sender who sent it, such as {@code 10.0.0.7:41234}: an address, a server or a file
 * @param received when it was complete, as {@link System#nanoTime}
 * @param utime microseconds since 1970: when it was complete by this machine's clock, or what the log says
 */
public record LcmMessage(String channel, ByteBuffer data, String sender, long received, long utime) {

  /** Sees to it that nobody can change the bytes. */
  public LcmMessage {
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
