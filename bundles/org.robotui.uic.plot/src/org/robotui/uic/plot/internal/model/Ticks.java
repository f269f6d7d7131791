package org.robotui.uic.plot.internal.model;

import org.robotui.ui.Figures;

/**
 * Round numbers along a scale.
 *
 * @param first the lowest
 * @param step from one to the next: 1, 2 or 5 times a power of ten
 * @param count how many
 */
public record Ticks(double first, double step, int count) {
  private static final double HALF = 1e-9;
  private static final int MOST_DECIMALS = 9;
  private static final double LARGE = 1e7;

  /** Ticks within limits, at most so many. */
  public static Ticks of(double low, double high, int most) {
    double step = Figures.roundStep((high - low) / Math.max(1, most - 1));
    double first = Math.ceil(low / step - HALF) * step;
    int count = (int) Math.max(0, Math.floor((high - first) / step + HALF) + 1);
    return new Ticks(first, step, Math.min(count, most + 1));
  }

  public double at(int index) {
    double value = first + index * step;
    return Math.abs(value) < step * HALF ? 0 : value;
  }

  /** As exact as the ticks need it. */
  public String label(int index) {
    return label(at(index));
  }

  /** A value, with the decimals of the ticks. */
  public String label(double value) {
    double largest = Math.max(Math.abs(first), Math.abs(at(count - 1)));
    if (largest >= LARGE || decimals() > MOST_DECIMALS) {
      return scientific(value, Math.max(0, exponent(largest) - exponent(step)));
    }
    return Figures.fixed(value, decimals());
  }

  /** Decimals with which neighbouring ticks differ. */
  public int decimals() {
    return Math.max(0, -exponent(step));
  }

  /** A number in the form {@code 1.25e6}. */
  static String scientific(double value, int decimals) {
    if (value == 0 || !Double.isFinite(value)) {
      return Figures.fixed(value, 0);
    }
    int exponent = exponent(Math.abs(value));
    return Figures.fixed(value / Math.pow(10, exponent), Math.min(decimals, MOST_DECIMALS)) + "e"
        + Figures.fixed(exponent, 0);
  }

  private static int exponent(double positive) {
    return (int) Math.floor(Math.log10(positive) + HALF);
  }
}
