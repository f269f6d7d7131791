package org.robotui.recording.internal.codec;

import java.util.Arrays;

/** Bytes that become more up to a limit. Room is made as they come: what a file says of their number is no promise. */
final class GrowingBytes {

  private final int limit;
  private byte[] bytes;
  private int length;

  GrowingBytes(int limit, int first) {
    this.limit = limit;
    bytes = new byte[Math.min(limit, first)];
  }

  /** Makes room for so many more, or for as many as the limit allows. Returns how many fit. */
  int room(int wanted) {
    int fitting = Math.min(wanted, limit - length);
    if (length + fitting > bytes.length) {
      bytes = Arrays.copyOf(bytes, (int) Math.min(limit, Math.max(length + (long) fitting, 2L * bytes.length)));
    }
    return fitting;
  }

  /** Where more is to be written from {@link #length} on, after {@link #room}. */
  byte[] array() {
    return bytes;
  }

  int length() {
    return length;
  }

  void written(int more) {
    length += more;
  }
}
