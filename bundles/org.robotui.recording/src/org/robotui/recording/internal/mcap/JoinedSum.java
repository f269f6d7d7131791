package org.robotui.recording.internal.mcap;

/** The checksum (CRC-32) of bytes after others, out of both checksums: bytes that were summed need no second look. */
final class JoinedSum {
  /** The polynomial of CRC-32, and numbers modulo it, have the coefficient of the power 0 in their highest bit. */
  private static final int POLYNOMIAL = 0xedb88320;
  private static final int ONE = 1 << 31;
  private static final int BITS_OF_BYTE = 8;

  private JoinedSum() {}

  /** Of the bytes that have the sum {@code first} and, behind them, {@code length} bytes that have {@code second}. */
  static int of(int first, int second, long length) {
    return product(first, power(length * BITS_OF_BYTE)) ^ second;
  }

  /** x to the power of n. */
  private static int power(long n) {
    int result = ONE;
    int square = ONE >>> 1;
    for (long left = n; left != 0; left >>>= 1) {
      if ((left & 1) != 0) {
        result = product(result, square);
      }
      square = product(square, square);
    }
    return result;
  }

  private static int product(int a, int b) {
    int sum = 0;
    int shifted = b;
    for (int bit = ONE; bit != 0; bit >>>= 1) {
      if ((a & bit) != 0) {
        sum ^= shifted;
      }
      shifted = (shifted & 1) == 0 ? shifted >>> 1 : shifted >>> 1 ^ POLYNOMIAL;
    }
    return sum;
  }
}
