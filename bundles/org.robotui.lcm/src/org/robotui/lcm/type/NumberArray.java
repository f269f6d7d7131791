package org.robotui.lcm.type;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Objects;

/** An array of numbers or truth values that stays in the bytes of its message. Immutable. */
public final class NumberArray {

  private final Primitive type;
  private final ByteBuffer bytes;
  private final List<Integer> shape;

  NumberArray(Primitive type, ByteBuffer bytes, List<Integer> shape) {
    this.type = type;
    this.bytes = bytes.slice().asReadOnlyBuffer().order(ByteOrder.BIG_ENDIAN);
    this.shape = List.copyOf(shape);
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
   * The size of each dimension.
   *
   * @return outermost first
   */
  public List<Integer> shape() {
    return shape;
  }

  /**
   * How many elements there are in all dimensions.
   *
   * @return the count
   */
  public int size() {
    return bytes.limit() / type.size();
  }

  /**
   * One element as a floating point number: truth values as 0 or 1.
   *
   * @param index from 0, row by row
   * @return the number
   * @throws IndexOutOfBoundsException if there is no such element
   */
  public double number(int index) {
    int at = Objects.checkIndex(index, size()) * type.size();
    return switch (type) {
      case FLOAT -> bytes.getFloat(at);
      case DOUBLE -> bytes.getDouble(at);
      default -> whole(index);
    };
  }

  /**
   * One element as an integer: truth values as 0 or 1, floating point numbers cut.
   *
   * @param index from 0, row by row
   * @return the number
   * @throws IndexOutOfBoundsException if there is no such element
   */
  public long whole(int index) {
    int at = Objects.checkIndex(index, size()) * type.size();
    return switch (type) {
      case INT8 -> bytes.get(at);
      case BYTE -> Byte.toUnsignedLong(bytes.get(at));
      case BOOLEAN -> bytes.get(at) != 0 ? 1 : 0;
      case INT16 -> bytes.getShort(at);
      case INT32 -> bytes.getInt(at);
      case INT64 -> bytes.getLong(at);
      case FLOAT -> (long) bytes.getFloat(at);
      case DOUBLE -> (long) bytes.getDouble(at);
      case STRING -> throw new IllegalStateException("texts are no numbers");
    };
  }

  /**
   * All elements as floating point numbers.
   *
   * @return a new array, row by row
   */
  public double[] toDoubles() {
    double[] values = new double[size()];
    if (type == Primitive.DOUBLE) {
      bytes.asDoubleBuffer().get(values);
    } else {
      for (int i = 0; i < values.length; i++) {
        values[i] = number(i);
      }
    }
    return values;
  }

  /**
   * All elements as single floating point numbers.
   *
   * @return a new array, row by row
   */
  public float[] toFloats() {
    float[] values = new float[size()];
    if (type == Primitive.FLOAT) {
      bytes.asFloatBuffer().get(values);
    } else {
      for (int i = 0; i < values.length; i++) {
        values[i] = (float) number(i);
      }
    }
    return values;
  }

  /**
   * The elements as they came.
   *
   * @return a read-only big-endian view
   */
  public ByteBuffer bytes() {
    return bytes.duplicate().order(ByteOrder.BIG_ENDIAN);
  }

  /** Equal when type, shape and bytes are. */
  @Override
  public boolean equals(Object other) {
    return other instanceof NumberArray array && type == array.type && shape.equals(array.shape)
        && bytes.equals(array.bytes);
  }

  @Override
  public int hashCode() {
    return Objects.hash(type, shape, bytes);
  }

  @Override
  public String toString() {
    return type.lcmName() + shape;
  }
}
