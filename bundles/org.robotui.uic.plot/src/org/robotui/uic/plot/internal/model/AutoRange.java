package org.robotui.uic.plot.internal.model;

import java.util.Optional;
import org.robotui.ui.Figures;
import org.robotui.uic.plot.internal.trace.Summary;

/**
 * Chooses the values that a scale shows from those that are there: with room around them, and without jumping at each
 * change.
 */
public final class AutoRange {
  private static final ValueSpan NOTHING = new ValueSpan(-1, 1);
  private static final double ROOM = 0.06;
  private static final double TOO_LARGE = 1.8;
  private static final double FLAT = 1e-9;
  private static final int STEPS = 5;
  private static final double MOST = 1e300;

  private AutoRange() {}

  /**
   * The range to show.
   *
   * @param seen the values in sight
   * @param before what was shown before, kept where it still fits
   * @param hold whether it never shrinks
   */
  public static ValueSpan next(Summary seen, Optional<ValueSpan> before, boolean hold) {
    if (seen.isEmpty()) {
      return before.orElse(NOTHING);
    }
    ValueSpan wanted = around(Math.clamp(seen.min(), -MOST, MOST), Math.clamp(seen.max(), -MOST, MOST));
    if (before.isEmpty()) {
      return wanted;
    }
    ValueSpan old = before.get();
    boolean inside = seen.min() >= old.low() && seen.max() <= old.high();
    if (hold) {
      return inside ? old : new ValueSpan(Math.min(old.low(), wanted.low()), Math.max(old.high(), wanted.high()));
    }
    return inside && old.length() <= TOO_LARGE * wanted.length() ? old : wanted;
  }

  /** Limits at round numbers with the values inside; around a constant there is room to both sides. */
  static ValueSpan around(double low, double high) {
    double size = Math.max(Math.abs(low), Math.abs(high));
    double room = high - low <= size * FLAT ? (size == 0 ? 1 : size * 0.1) : (high - low) * ROOM;
    double step = Figures.roundStep((high - low + 2 * room) / STEPS) / 2;
    return new ValueSpan(Math.floor((low - room) / step) * step, Math.ceil((high + room) / step) * step);
  }
}
