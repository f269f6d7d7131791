package org.robotui.web.tree;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Arrays of numbers of one type, by the tags of RFC 8746. */
final class TypedArray {

  private TypedArray() {}

  /** {@code byte[]} for bytes, else {@code long[]} or {@code double[]}. */
  static Object read(int tag, byte[] bytes) throws TreeException {
    boolean real = (tag & 0b1_0000) != 0;
    boolean signed = (tag & 0b1000) != 0;
    boolean little = (tag & 0b100) != 0;
    int sizeLog = tag & 0b11;
    int size = real ? 2 << sizeLog : 1 << sizeLog;
    if (size > 8 || bytes.length % size != 0) {
      throw new TreeException("a typed array with the tag " + tag + " and " + bytes.length + " bytes");
    }
    if (!real && size == 1) {
      return bytes;
    }
    ByteBuffer in = ByteBuffer.wrap(bytes).order(little ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
    return real ? reals(in, size) : wholes(in, size, signed);
  }

  private static double[] reals(ByteBuffer in, int size) {
    double[] numbers = new double[in.remaining() / size];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = switch (size) {
        case 2 -> Float.float16ToFloat(in.getShort());
        case 4 -> in.getFloat();
        default -> in.getDouble();
      };
    }
    return numbers;
  }

  /** Unsigned numbers of 64 bits are their bits. */
  private static long[] wholes(ByteBuffer in, int size, boolean signed) {
    long[] numbers = new long[in.remaining() / size];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = switch (size) {
        case 2 -> signed ? in.getShort() : in.getShort() & 0xFFFFL;
        case 4 -> signed ? in.getInt() : in.getInt() & 0xFFFF_FFFFL;
        default -> in.getLong();
      };
    }
    return numbers;
  }
}
