package org.robotui.sim.internal.camera;

/** Arithmetic of colours packed as 0xrrggbb. */
final class Rgb {
  private Rgb() {}

  /** Multiplies the brightness; 256 leaves it as it is. */
  static int scale(int colour, int factor) {
    int r = Math.min(255, ((colour >> 16 & 255) * factor) >> 8);
    int g = Math.min(255, ((colour >> 8 & 255) * factor) >> 8);
    int b = Math.min(255, ((colour & 255) * factor) >> 8);
    return r << 16 | g << 8 | b;
  }

  static int scale(int colour, double factor) {
    return scale(colour, (int) (factor * 256));
  }

  /** {@code weight} 0 gives a, 1 gives b. */
  static int mix(int a, int b, double weight) {
    int r = mixed(a >> 16 & 255, b >> 16 & 255, weight);
    int g = mixed(a >> 8 & 255, b >> 8 & 255, weight);
    return r << 16 | g << 8 | mixed(a & 255, b & 255, weight);
  }

  private static int mixed(int a, int b, double weight) {
    return (int) Math.round(a + (b - a) * weight);
  }
}
