package org.robotui.recording.internal.sqlite;

import org.robotui.recording.internal.io.MalformedRecord;

/** Numbers of one to nine bytes, one after another. */
final class SqliteNumbers {

  private static final int LONGEST = 9;

  private final byte[] bytes;
  private final int end;
  private int at;

  SqliteNumbers(byte[] bytes, int from, int end) {
    this.bytes = bytes;
    this.at = from;
    this.end = end;
  }

  int at() {
    return at;
  }

  long next() throws MalformedRecord {
    long value = 0;
    for (int i = 1; i <= LONGEST; i++) {
      if (at >= end) {
        throw new MalformedRecord("a number ends early");
      }
      int each = bytes[at++] & 0xff;
      if (i == LONGEST) {
        return value << 8 | each;
      }
      value = value << 7 | each & 0x7f;
      if (each < 0x80) {
        return value;
      }
    }
    return value;
  }
}
