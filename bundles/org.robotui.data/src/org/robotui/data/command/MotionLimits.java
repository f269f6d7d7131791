package org.robotui.data.command;

import org.robotui.data.internal.Check;

/**
 * How fast something may be commanded to move.
 *
 * @param linear metres per second
 * @param angular radians per second
 */
public record MotionLimits(double linear, double angular) {
  /** No limit. */
  public static final MotionLimits NONE = new MotionLimits(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);

  /**
   * Checks the signs.
   *
   * @param linear metres per second
   * @param angular radians per second
   */
  public MotionLimits {
    Check.notNegative(linear, "linear");
    Check.notNegative(angular, "angular");
  }

  /**
   * The stricter of two.
   *
   * @param other other limits
   * @return the minimum of both
   */
  public MotionLimits and(MotionLimits other) {
    return new MotionLimits(Math.min(linear, other.linear), Math.min(angular, other.angular));
  }
}
