package org.robotui.web.tree;

import java.util.Arrays;

/** Collects the numbers of an array without an object for each. Integers become reals when a real comes among them. */
final class NumberArray {

  private static final int FIRST = 16;

  private long[] whole = new long[FIRST];
  private double[] real = new double[0];
  private boolean isReal;
  private int size;

  void add(long number) {
    if (isReal) {
      room();
      real[size++] = number;
      return;
    }
    if (size == whole.length) {
      whole = Arrays.copyOf(whole, 2 * size);
    }
    whole[size++] = number;
  }

  void add(double number) {
    if (!isReal) {
      real = new double[Math.max(FIRST, whole.length)];
      for (int i = 0; i < size; i++) {
        real[i] = whole[i];
      }
      whole = new long[0];
      isReal = true;
    }
    room();
    real[size++] = number;
  }

  private void room() {
    if (size == real.length) {
      real = Arrays.copyOf(real, 2 * size);
    }
  }

  int size() {
    return size;
  }

  /** One of them, as it is held in a list. */
  Object at(int index) {
    return isReal ? (Object) real[index] : (Object) whole[index];
  }

  /** {@code long[]} or {@code double[]}. */
  Object array() {
    return isReal ? Arrays.copyOf(real, size) : Arrays.copyOf(whole, size);
  }
}
