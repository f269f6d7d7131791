package org.robotui.entity.grid;

import java.util.stream.IntStream;
import org.robotui.ui.Figures;

/** Round distances: 1, 2 or 5 times a power of ten. */
public final class GridSteps {
  private static final double[] ROUND = {1, 2, 5, 10};
  private static final double KILOMETRE = 1000;
  private static final int MOST = 1000;

  private GridSteps() {}

  /**
   * The multiples of a distance within a range. There are a thousand at most, whatever the numbers are: nobody can tell
   * more lines apart.
   *
   * @param low from here, metres
   * @param high to here
   * @param step the distance
   * @return the multiples, upwards; none where there is no such range
   */
  static double[] within(double low, double high, double step) {
    double first = Math.ceil(low / step);
    int count = (int) Math.clamp(Math.floor(high / step) - first + 1, 0, MOST); // 0 for what is no number
    return IntStream.range(0, count).mapToDouble(i -> (first + i) * step).toArray();
  }

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
