package org.robotui.gl.shape;

import java.nio.ByteBuffer;

/** Checks of buffers that colours come in. */
final class Colors {
  private Colors() {}

  /** Checks that there is no colour, or one for each. */
  static void fit(ByteBuffer rgba, int count) {
    if (rgba.remaining() != 4 * count) {
      throw new IllegalArgumentException(
          "colours: " + rgba.remaining() + " bytes for " + count + ", must be four each");
    }
  }
}
