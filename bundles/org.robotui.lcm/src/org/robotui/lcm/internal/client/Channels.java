package org.robotui.lcm.internal.client;

import java.nio.charset.StandardCharsets;

/** The names of channels. */
public final class Channels {

  /** As many bytes as all implementations take. */
  public static final int MOST_BYTES = 63;

  private Channels() {}

  /** The bytes of a name that is to be sent. */
  static byte[] encode(String channel) {
    byte[] bytes = channel.getBytes(StandardCharsets.UTF_8);
    if (bytes.length == 0 || bytes.length > MOST_BYTES || channel.indexOf('\0') >= 0) {
      throw new IllegalArgumentException("'" + channel + "' is no channel: a name has 1 to " + MOST_BYTES + " bytes");
    }
    return bytes;
  }
}
