package org.robotui.gl.display;

import org.robotui.gl.shape.ColorRamp;

/**
 * What the colours of a display mean.
 *
 * @param title what the numbers are
 * @param unit of the numbers; empty where none is known
 * @param low the number of the first colour
 * @param high the number of the last colour, not less
 * @param ramp the colours
 * @param reversed whether they begin with the last
 */
public record ColorScale(String title, String unit, double low, double high, ColorRamp ramp, boolean reversed) {
  private static final int NOTHING = 0x808080;

  /**
   * The colour of a number.
   *
   * @param value the number
   * @return red, green and blue, a byte each; grey where it is no number
   */
  public int rgb(double value) {
    if (Double.isNaN(value)) {
      return NOTHING;
    }
    return high > low ? shade((value - low) / (high - low)) : shade(0.5);
  }

  /**
   * A colour of the scale.
   *
   * @param share 0 the lowest to 1 the highest
   * @return red, green and blue, a byte each
   */
  public int shade(double share) {
    return ramp.rgb(reversed ? 1 - share : share);
  }
}
