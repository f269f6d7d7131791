package org.robotui.recording.internal.bag;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** The header of a message. Most records of a bag are messages: nothing is made of each but what it says. */
final class BagMessageHead {

  private static final int OP_FIELD = 4;
  private static final int CONNECTION_FIELD = 9;
  private static final int TIME_FIELD = 13;
  private static final int ALL = 7;

  private final byte[] bytes;
  private final ByteBuffer view;
  private int connection;
  private long time;

  BagMessageHead(byte[] bytes) {
    this.bytes = bytes;
    view = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Whether a range is such a header, and nothing is wrong with it. */
  boolean read(int from, int to) {
    int found = 0;
    int at = from;
    while (to - at >= Integer.BYTES) {
      int length = view.getInt(at);
      at += Integer.BYTES;
      if (length < 0 || length > to - at) {
        return false;
      }
      found |= field(at, length);
      at += length;
    }
    return at == to && found == ALL;
  }

  private int field(int at, int length) {
    if (length == OP_FIELD && is(at, "op=")) {
      return bytes[at + 3] == BagFields.MESSAGE ? 1 : 0;
    }
    if (length == CONNECTION_FIELD && is(at, "conn=")) {
      connection = view.getInt(at + 5);
      return 2;
    }
    if (length == TIME_FIELD && is(at, "time=")) {
      time = (view.getInt(at + 5) & 0xffff_ffffL) * 1_000_000_000L + (view.getInt(at + 9) & 0xffff_ffffL);
      return 4;
    }
    return 0;
  }

  private boolean is(int at, String name) {
    for (int i = 0; i < name.length(); i++) {
      if (bytes[at + i] != name.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  int connection() {
    return connection;
  }

  long time() {
    return time;
  }
}
