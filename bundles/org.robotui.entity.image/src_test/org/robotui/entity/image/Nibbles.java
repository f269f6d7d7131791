package org.robotui.entity.image;

import java.util.stream.IntStream;

/** Writes RVL numbers. */
final class Nibbles {
  private final StringBuilder hex = new StringBuilder();

  void add(int number) {
    int rest = number;
    do {
      int part = rest & 7;
      rest >>>= 3;
      hex.append(Integer.toHexString(rest == 0 ? part : part | 8));
    } while (rest != 0);
  }

  IntStream words() {
    String padded = hex + "0".repeat(7 - (hex.length() + 7) % 8);
    return IntStream.range(0, padded.length() / 8)
        .map(i -> Integer.parseUnsignedInt(padded.substring(8 * i, 8 * i + 8), 16));
  }
}
