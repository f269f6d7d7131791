package org.robotui.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Objects;

/** An array of numbers, bools, times or durations that stays in the bytes of its message. Immutable. */
public final class PrimitiveArray {

  private final Primitive type;
  private final ByteBuffer bytes;

  PrimitiveArray(Primitive type, ByteBuffer bytes) {
    this.type = type;
    this.bytes = bytes.slice().asReadOnlyBuffer().order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * The type of the elements.
   *
   * @return any built-in type but {@link Primitive#STRING}
   */
  public Primitive type() {
    return type;
  }

  /**
   * How many elements there are.
   *
   * @return the count
   */
  public int size() {
    return bytes.limit() / type.size();
  }

  /**
   * One element as a floating point number: bools as 0 or 1, times in seconds.
   *
   * @param index from 0
   * @return the number
   * @throws IndexOutOfBoundsException if there is no such element
   */
  public double number(int index) {
    int at = Objects.checkIndex(index, size()) * type.size();
    return switch (type) {
      case FLOAT32 -> bytes.getFloat(at);
      case FLOAT64 -> bytes.getDouble(at);
      case TIME, DURATION -> whole(index) * 1e-9;
      case UINT64 -> unsigned(bytes.getLong(at));
      default -> whole(index);
    };
  }

  /**
   * One element as an integer: times in nanoseconds, floating point numbers cut.
   *
   * @param index from 0
   * @return the number; for {@code uint64} its bits
   * @throws IndexOutOfBoundsException if there is no such element
   */
  public long whole(int index) {
    int at = Objects.checkIndex(index, size()) * type.size();
    return wholeAt(type, bytes, at);
  }

  /**
   * One element as the value of a field.
   *
   * @param index from 0
   * @return the value
   * @throws IndexOutOfBoundsException if there is no such element
   */
  public RosValue value(int index) {
    int at = Objects.checkIndex(index, size()) * type.size();
    return valueAt(type, bytes, at);
  }

  /**
   * All elements as floating point numbers.
   *
   * @return a new array, converted as {@link #number} does
   */
  public double[] toDoubles() {
    double[] values = new double[size()];
    if (type == Primitive.FLOAT64) {
      bytes.asDoubleBuffer().get(values);
    } else {
      for (int i = 0; i < values.length; i++) {
        values[i] = number(i);
      }
    }
    return values;
  }

  /**
   * The elements as they came.
   *
   * @return a read-only little-endian view
   */
  public ByteBuffer bytes() {
    return bytes.duplicate().order(ByteOrder.LITTLE_ENDIAN);
  }

  static RosValue valueAt(Primitive type, ByteBuffer bytes, int at) {
    return switch (type) {
      case BOOL -> new RosValue.Flag(bytes.get(at) != 0);
      case FLOAT32 -> new RosValue.Real(bytes.getFloat(at), type);
      case FLOAT64 -> new RosValue.Real(bytes.getDouble(at), type);
      case TIME, DURATION -> new RosValue.Instant(wholeAt(type, bytes, at), type);
      default -> new RosValue.Whole(wholeAt(type, bytes, at), type);
    };
  }

  private static long wholeAt(Primitive type, ByteBuffer bytes, int at) {
    return switch (type) {
      case BOOL -> bytes.get(at) != 0 ? 1 : 0;
      case INT8, BYTE -> bytes.get(at);
      case UINT8, CHAR -> Byte.toUnsignedLong(bytes.get(at));
      case INT16 -> bytes.getShort(at);
      case UINT16 -> Short.toUnsignedLong(bytes.getShort(at));
      case INT32 -> bytes.getInt(at);
      case UINT32 -> Integer.toUnsignedLong(bytes.getInt(at));
      case INT64, UINT64 -> bytes.getLong(at);
      case FLOAT32 -> (long) bytes.getFloat(at);
      case FLOAT64 -> (long) bytes.getDouble(at);
      case TIME -> Stamps.time(bytes.getInt(at), bytes.getInt(at + Integer.BYTES));
      case DURATION -> Stamps.duration(bytes.getInt(at), bytes.getInt(at + Integer.BYTES));
      case STRING, WSTRING -> throw new IllegalArgumentException("texts are no primitive array");
    };
  }

  private static double unsigned(long bits) {
    return bits >= 0 ? bits : ((bits >>> 1) | (bits & 1)) * 2.0;
  }

  static double wholeAsDouble(RosValue.Whole whole) {
    return whole.type() == Primitive.UINT64 ? unsigned(whole.value()) : whole.value();
  }

  @Override
  public String toString() {
    return type.rosName() + "[" + size() + "]";
  }
}
