package org.robotui.entity.image.internal;

import org.robotui.data.image.PixelEncoding;

/**
 * What the numbers of a picture stand for.
 *
 * @param unit empty where none is known
 * @param scale from the number sent to the unit
 * @param depth whether numbers that are not positive say that nothing was measured
 */
record Quantity(String unit, double scale, boolean depth) {
  private static final double MILLI = 1e-3;

  static Quantity of(PixelEncoding encoding, boolean depth) {
    return switch (encoding) {
      case U16C1 -> depth ? new Quantity("m", MILLI, true) : plain();
      case F32C1, F64C1 -> depth ? new Quantity("m", 1, true) : plain();
      default -> plain();
    };
  }

  private static Quantity plain() {
    return new Quantity("", 1, false);
  }

  /** Whether a number says something. */
  boolean measured(double number) {
    return Double.isFinite(number) && (!depth || number > 0);
  }
}
