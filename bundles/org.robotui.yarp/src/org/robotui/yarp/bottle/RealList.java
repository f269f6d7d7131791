package org.robotui.yarp.bottle;

import java.nio.ByteBuffer;
import java.util.AbstractList;
import java.util.RandomAccess;

/** Fractions of one width, kept as numbers: scans and joints are such lists, of hundreds of values. */
final class RealList extends AbstractList<YarpValue> implements RandomAccess {
  private final double[] numbers;
  private final int bits;

  /** The numbers are not copied. */
  RealList(double[] numbers, int bits) {
    this.numbers = numbers;
    this.bits = bits;
  }

  /** All that a buffer holds. */
  static RealList read(ByteBuffer bytes, int bits) {
    double[] numbers = new double[bytes.remaining() / (bits / Byte.SIZE)];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = bits == Float.SIZE ? bytes.getFloat() : bytes.getDouble();
    }
    return new RealList(numbers, bits);
  }

  int tag() {
    return BottleTag.real(bits);
  }

  double[] numbers() {
    return numbers.clone();
  }

  @Override
  public YarpValue get(int index) {
    return new YarpValue.Real(numbers[index], bits);
  }

  @Override
  public int size() {
    return numbers.length;
  }
}
