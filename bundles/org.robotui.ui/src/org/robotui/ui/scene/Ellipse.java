package org.robotui.ui.scene;

import java.util.Optional;

/**
 * The ellipse within which a point in the plane lies with some certainty.
 *
 * @param major half the longer axis, metres
 * @param minor half the shorter axis, metres
 * @param angle of the longer axis, radians
 */
public record Ellipse(double major, double minor, double angle) {
  private static final int CORNERS = 48;

  /**
   * From the variances of a position.
   *
   * @param xx variance of x, square metres
   * @param xy covariance of x and y
   * @param yy variance of y
   * @param sigmas how many standard deviations
   * @return the ellipse, or none where the numbers are no covariance or say nothing (all zero)
   */
  public static Optional<Ellipse> ofCovariance(double xx, double xy, double yy, double sigmas) {
    double middle = (xx + yy) / 2;
    double spread = Math.hypot((xx - yy) / 2, xy);
    double large = middle + spread;
    double small = middle - spread;
    if (!Double.isFinite(large) || !(large > 0) || small < -1e-9 * large) {
      return Optional.empty();
    }
    double angle = Math.atan2(2 * xy, xx - yy) / 2;
    return Optional.of(new Ellipse(sigmas * Math.sqrt(large), sigmas * Math.sqrt(Math.max(0, small)), angle));
  }

  /**
   * The ellipse in another frame.
   *
   * @param yaw how the frame of this one is turned there, radians
   * @return the turned ellipse
   */
  public Ellipse turned(double yaw) {
    return new Ellipse(major, minor, angle + yaw);
  }

  /**
   * Its outline.
   *
   * @param x centre, metres
   * @param y centre, metres
   * @return x and y of corners in turn
   */
  public double[] outline(double x, double y) {
    double[] xy = new double[2 * CORNERS];
    double cos = Math.cos(angle);
    double sin = Math.sin(angle);
    for (int i = 0; i < CORNERS; i++) {
      double at = 2 * Math.PI * i / CORNERS;
      double a = major * Math.cos(at);
      double b = minor * Math.sin(at);
      xy[2 * i] = x + a * cos - b * sin;
      xy[2 * i + 1] = y + a * sin + b * cos;
    }
    return xy;
  }
}
