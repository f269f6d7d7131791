package org.robotui.urdf.internal.mesh;

import java.nio.FloatBuffer;
import java.util.Arrays;

/** Numbers that become more. */
final class FloatList {
  private float[] numbers = new float[48];
  private int size;

  void add(float number) {
    if (size == numbers.length) {
      numbers = Arrays.copyOf(numbers, size + (size >> 1));
    }
    numbers[size++] = number;
  }

  float get(int index) {
    return numbers[index];
  }

  void set(int index, float number) {
    numbers[index] = number;
  }

  int size() {
    return size;
  }

  FloatBuffer buffer() {
    return FloatBuffer.wrap(Arrays.copyOf(numbers, size));
  }
}
