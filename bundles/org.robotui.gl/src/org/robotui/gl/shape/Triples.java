package org.robotui.gl.shape;

import java.nio.FloatBuffer;

/** Checks of buffers that coordinates come in. */
final class Triples {
  private Triples() {}

  static void check(FloatBuffer xyz, String what) {
    if (xyz.remaining() % 3 != 0) {
      throw new IllegalArgumentException(what + ": " + xyz.remaining() + " numbers, must be three each");
    }
  }

  /** Checks that there are as many numbers as one per corner takes. */
  static void fit(FloatBuffer numbers, int count, int each, String what) {
    if (numbers.remaining() != count * each) {
      throw new IllegalArgumentException(
          what + ": " + numbers.remaining() + " numbers for " + count + ", must be " + each + " each");
    }
  }
}
