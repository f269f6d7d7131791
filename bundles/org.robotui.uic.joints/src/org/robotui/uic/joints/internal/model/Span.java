package org.robotui.uic.joints.internal.model;

/**
 * From where to where a joint moves.
 *
 * @param min the lowest position, NaN where none is known
 * @param max the highest
 * @param configured true for limits of the configuration, false for what was seen
 */
public record Span(double min, double max, boolean configured) {
  /** Nothing is known. */
  public static final Span NONE = new Span(Double.NaN, Double.NaN, false);

  /** The span with one position more. Positions that are not finite change nothing. */
  public Span with(double position) {
    if (configured || !Double.isFinite(position)) {
      return this;
    }
    return isKnown() ? new Span(Math.min(min, position), Math.max(max, position), false)
        : new Span(position, position, false);
  }

  /** Whether there is one. */
  public boolean isKnown() {
    return !Double.isNaN(min) && !Double.isNaN(max);
  }

  /**
   * Where a position lies, 0 at the lowest and 1 at the highest, the middle where they are the same; NaN where unknown.
   */
  public double share(double position) {
    if (!isKnown() || !Double.isFinite(position)) {
      return Double.NaN;
    }
    return max > min ? Math.clamp((position - min) / (max - min), 0.0, 1.0) : 0.5;
  }

  /** Whether a position lies outside of configured limits. */
  public boolean isBeyond(double position) {
    return configured && (position < min || position > max);
  }
}
