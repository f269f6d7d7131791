package org.robotui.uic.plot.internal.model;

import org.robotui.ui.Figures;

/** Single values as users read them: about four digits, of the same length while the magnitude stays. */
public final class Readout {
  private static final int DIGITS = 4;
  private static final double LARGE = 1e7;
  private static final double SMALL = 1e-4;

  private Readout() {}

  public static String of(double value) {
    double size = Math.abs(value);
    if (!Double.isFinite(value) || size == 0) {
      return Figures.fixed(value, 3);
    }
    if (size >= LARGE || size < SMALL) {
      return Ticks.scientific(value, 3);
    }
    int whole = Math.max(1, (int) Math.floor(Math.log10(size)) + 1);
    return Figures.fixed(value, Math.clamp(DIGITS - whole, 0, size < 0.1 ? 4 : 3));
  }

  public static String of(double value, String unit) {
    return unit.isEmpty() ? of(value) : of(value) + "\u00a0" + unit;
  }
}
