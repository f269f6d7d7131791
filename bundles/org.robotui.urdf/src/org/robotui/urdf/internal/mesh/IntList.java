package org.robotui.urdf.internal.mesh;

import java.nio.IntBuffer;
import java.util.Arrays;

/** Whole numbers that become more. */
final class IntList {
  private int[] numbers = new int[48];
  private int size;

  void add(int number) {
    if (size == numbers.length) {
      numbers = Arrays.copyOf(numbers, size + (size >> 1));
    }
    numbers[size++] = number;
  }

  int get(int index) {
    return numbers[index];
  }

  int size() {
    return size;
  }

  void clear() {
    size = 0;
  }

  IntBuffer buffer() {
    return IntBuffer.wrap(Arrays.copyOf(numbers, size));
  }
}
