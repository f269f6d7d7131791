package org.robotui.entity.grid;

import org.robotui.ui.Figures;

/** Round distances: 1, 2 or 5 times a power of ten. */
public final class GridSteps {
  private static final double[] ROUND = {1, 2, 5, 10};
  private static final double KILOMETRE = 1000;

  private GridSteps() {}

  /**
   * The smallest round distance that is at least so many pixels long.
   *
   * @param scale pixels per metre
   * @param pixels at least so long
   * @return metres
   */
  public static double atLeast(double scale, double pixels) {
    double wanted = pixels / scale;
    double power = Math.pow(10, Math.floor(Math.log10(wanted)));
    for (double factor : ROUND) {
      if (factor * power >= wanted * (1 - 1e-9)) {
        return factor * power;
      }
    }
    return 10 * power;
  }

  /**
   * A round distance as users read it.
   *
   * @param metres the distance
   * @return for example {@code 2 m}, {@code 50 cm}, {@code 5 km}
   */
  public static String label(double metres) {
    if (metres >= KILOMETRE) {
      return Figures.of(metres / KILOMETRE, 0, "km");
    }
    if (metres >= 1) {
      return Figures.of(metres, 0, "m");
    }
    return metres >= 0.01 ? Figures.of(metres * 100, 0, "cm") : Figures.of(metres * 1000, 0, "mm");
  }
}
