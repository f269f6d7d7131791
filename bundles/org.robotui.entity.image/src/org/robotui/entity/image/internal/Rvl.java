package org.robotui.entity.image.internal;

import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * Depth as runs of zeros and of differences (RVL): numbers of three bits a nibble with a bit that says whether more
 * follow, the nibbles from the upper end of little endian words of 32 bits.
 */
final class Rvl {
  private static final int MORE = 8;
  private static final int PART = 7;
  private static final int PART_BITS = 3;
  private static final int MOST_BITS = 30;
  private static final int NIBBLES = 8;
  private static final int NIBBLE_BITS = 4;

  private final ByteBuffer words;
  private int word;
  private int nibbles;

  private Rvl(ByteBuffer words) {
    this.words = words;
  }

  /** Decodes as many numbers as the array takes. */
  static void decode(ByteBuffer words, short[] target) throws IOException {
    new Rvl(words).decode(target);
  }

  private void decode(short[] target) throws IOException {
    int at = 0;
    int value = 0;
    while (at < target.length) {
      at += run(target.length - at);
      int numbers = run(target.length - at);
      for (int end = at + numbers; at < end; at++) {
        int folded = number();
        value += folded >>> 1 ^ -(folded & 1);
        target[at] = (short) value;
      }
    }
  }

  private int run(int room) throws IOException {
    int length = number();
    if (length > room) {
      throw new IOException("a run of " + length + " pixels where " + room + " are left");
    }
    return length;
  }

  private int number() throws IOException {
    int value = 0;
    for (int bits = 0; bits <= MOST_BITS; bits += PART_BITS) {
      int nibble = nibble();
      value |= (nibble & PART) << bits;
      if ((nibble & MORE) == 0) {
        return value & Integer.MAX_VALUE;
      }
    }
    throw new IOException("a number of more than 32 bits");
  }

  private int nibble() throws IOException {
    if (nibbles == 0) {
      if (words.remaining() < Integer.BYTES) {
        throw new IOException("the data end too early");
      }
      word = words.getInt();
      nibbles = NIBBLES;
    }
    nibbles--;
    return word >>> NIBBLE_BITS * nibbles & 0xf;
  }
}
