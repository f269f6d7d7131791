package org.robotui.data.array;

import java.nio.DoubleBuffer;
import java.util.Arrays;

/** An immutable sequence of double precision numbers. */
public final class Doubles {
  /** No numbers. */
  public static final Doubles EMPTY = new Doubles(new double[0]);

  private final double[] values;

  private Doubles(double[] values) {
    this.values = values;
  }

  /**
   * Copies the numbers.
   *
   * @param values the numbers
   * @return the sequence
   */
  public static Doubles of(double... values) {
    return new Doubles(values.clone());
  }

  /**
   * Takes the array over without a copy, for hot paths.
   *
   * @param values the numbers; the caller must not touch the array again
   * @return the sequence
   */
  public static Doubles wrap(double[] values) {
    return new Doubles(values);
  }

  /**
   * One number.
   *
   * @param index from 0
   * @return the number
   */
  public double get(int index) {
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
  public DoubleBuffer buffer() {
    return DoubleBuffer.wrap(values).asReadOnlyBuffer();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Doubles doubles && Arrays.equals(values, doubles.values);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(values);
  }

  @Override
  public String toString() {
    return "Doubles[" + values.length + "]";
  }
}
