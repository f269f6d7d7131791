package org.robotui.gl.shape;

import java.util.Optional;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.Vector3;

/**
 * How far a place is uncertain: one standard deviation along the axes of an ellipsoid.
 *
 * @param rotation the frame of the covariance from the ellipsoid's axes
 * @param deviations along its x, y, z, 0 or more
 */
public record Ellipsoid(Quaternion rotation, Vector3 deviations) {
  private static final int SWEEPS = 20;

  /**
   * The ellipsoid of a covariance, of which only one half is read (it is symmetric). Variances below 0 count as 0.
   *
   * @param xx variance of x, square of the unit
   * @param xy covariance
   * @param xz covariance
   * @param yy variance of y
   * @param yz covariance
   * @param zz variance of z
   * @return the ellipsoid, or none where a number is not finite
   */
  public static Optional<Ellipsoid> of(double xx, double xy, double xz, double yy, double yz, double zz) {
    double sum = xx + xy + xz + yy + yz + zz;
    if (!Double.isFinite(sum)) {
      return Optional.empty();
    }
    double[][] a = {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
    Quaternion axes = Quaternion.IDENTITY;
    for (int sweep = 0; sweep < SWEEPS && a[0][1] * a[0][1] + a[0][2] * a[0][2] + a[1][2] * a[1][2] > 0; sweep++) {
      axes = turn(a, axes, 0, 1);
      axes = turn(a, axes, 0, 2);
      axes = turn(a, axes, 1, 2);
    }
    Vector3 deviations = new Vector3(deviation(a[0][0]), deviation(a[1][1]), deviation(a[2][2]));
    return Optional.of(new Ellipsoid(axes.normalized(), deviations)).filter(e -> e.deviations.isFinite());
  }

  private static double deviation(double variance) {
    return Math.sqrt(Math.max(0, variance));
  }

  /** Jacobi: turns two axes so that their covariance is 0. */
  private static Quaternion turn(double[][] a, Quaternion axes, int p, int q) {
    if (a[p][q] == 0) {
      return axes;
    }
    double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double angle = Math.atan(Math.copySign(1, theta) / (Math.abs(theta) + Math.sqrt(theta * theta + 1)));
    double c = Math.cos(angle);
    double s = Math.sin(angle);
    for (int k = 0; k < 3; k++) {
      double atP = a[k][p];
      a[k][p] = c * atP - s * a[k][q];
      a[k][q] = s * atP + c * a[k][q];
    }
    for (int k = 0; k < 3; k++) {
      double atP = a[p][k];
      a[p][k] = c * atP - s * a[q][k];
      a[q][k] = s * atP + c * a[q][k];
    }
    a[p][q] = 0;
    a[q][p] = 0;
    return axes.times(about(3 - p - q, q - p == 2 ? angle : -angle));
  }

  private static Quaternion about(int axis, double angle) {
    double s = Math.sin(angle / 2);
    return new Quaternion(axis == 0 ? s : 0, axis == 1 ? s : 0, axis == 2 ? s : 0, Math.cos(angle / 2));
  }
}
