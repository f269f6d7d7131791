package org.robotui.yarp.bottle;

/** The numbers by which bottles say of what type something is. */
final class BottleTag {
  static final int INT32 = 1;
  static final int STRING = 4;
  static final int VOCAB = 9;
  static final int FLOAT64 = 10;
  static final int BLOB = 12;
  static final int INT64 = 17;
  static final int INT8 = 32;
  static final int INT16 = 64;
  static final int FLOAT32 = 128;
  static final int LIST = 256;

  private BottleTag() {}

  static int whole(int bits) {
    return switch (bits) {
      case Byte.SIZE -> INT8;
      case Short.SIZE -> INT16;
      case Integer.SIZE -> INT32;
      case Long.SIZE -> INT64;
      default -> throw new IllegalArgumentException("whole numbers have 8, 16, 32 or 64 bits, not " + bits);
    };
  }

  static int real(int bits) {
    return switch (bits) {
      case Float.SIZE -> FLOAT32;
      case Double.SIZE -> FLOAT64;
      default -> throw new IllegalArgumentException("fractions have 32 or 64 bits, not " + bits);
    };
  }

  static int of(YarpValue value) {
    return switch (value) {
      case YarpValue.Whole whole -> whole(whole.bits());
      case YarpValue.Real real -> real(real.bits());
      case YarpValue.Text text -> STRING;
      case YarpValue.Vocab vocab -> VOCAB;
      case YarpValue.Blob blob -> BLOB;
      case Bottle bottle -> LIST + bottle.element();
    };
  }

  /** The fewest bytes that a value of a type takes behind its tag. */
  static int least(int tag) {
    return switch (tag) {
      case INT8 -> Byte.BYTES;
      case INT16 -> Short.BYTES;
      case INT64, FLOAT64 -> Long.BYTES;
      default -> Integer.BYTES;
    };
  }
}
