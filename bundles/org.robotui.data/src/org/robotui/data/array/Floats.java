package org.robotui.data.array;

import java.nio.FloatBuffer;
import java.util.Arrays;

/** An immutable sequence of single precision numbers. */
public final class Floats {
  /** No numbers. */
  public static final Floats EMPTY = new Floats(new float[0]);

  private final float[] values;

  private Floats(float[] values) {
    this.values = values;
  }

  /**
   * Copies the numbers.
   *
   * @param values the numbers
   * @return the sequence
   */
  public static Floats of(float... values) {
    return new Floats(values.clone());
  }

  /**
   * Takes the array over without a copy, for hot paths.
   *
   * @param values the numbers; the caller must not touch the array again
   * @return the sequence
   */
  public static Floats wrap(float[] values) {
    return new Floats(values);
  }

  /**
   * One number.
   *
   * @param index from 0
   * @return the number
   */
  public float get(int index) {
    return values[index];
  }

  /**
   * How many.
   *
   * @return the count
   */
  public int size() {
    return values.length;
  }

  /**
   * A read-only view for bulk access.
   *
   * @return a buffer from 0 to {@link #size()}
   */
  public FloatBuffer buffer() {
    return FloatBuffer.wrap(values).asReadOnlyBuffer();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Floats floats && Arrays.equals(values, floats.values);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(values);
  }

  @Override
  public String toString() {
    return "Floats[" + values.length + "]";
  }
}
