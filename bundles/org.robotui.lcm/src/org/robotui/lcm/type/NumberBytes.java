package org.robotui.lcm.type;

import java.nio.ByteBuffer;

/** Numbers as they are sent. */
final class NumberBytes {

  private NumberBytes() {}

  static ByteBuffer of(Primitive type, double[] values) {
    ByteBuffer bytes = ByteBuffer.allocate(Math.multiplyExact(values.length, type.size()));
    for (double value : values) {
      put(bytes, type, value);
    }
    return bytes.flip();
  }

  private static void put(ByteBuffer bytes, Primitive type, double value) {
    switch (type) {
      case DOUBLE -> bytes.putDouble(value);
      case FLOAT -> bytes.putFloat((float) value);
      case BOOLEAN -> bytes.put((byte) (value != 0 ? 1 : 0));
      case INT16 -> bytes.putShort((short) whole(type, value));
      case INT32 -> bytes.putInt((int) whole(type, value));
      case INT64 -> bytes.putLong(whole(type, value));
      default -> bytes.put((byte) whole(type, value));
    }
  }

  private static long whole(Primitive type, double value) {
    if (value != Math.rint(value) || !type.holds((long) value)) {
      throw new IllegalArgumentException(value + " is no " + type.lcmName());
    }
    return (long) value;
  }
}
