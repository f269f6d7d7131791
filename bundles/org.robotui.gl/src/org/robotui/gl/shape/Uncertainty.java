package org.robotui.gl.shape;

import java.util.Optional;
import org.robotui.data.array.Doubles;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** What is drawn of the covariance of a pose: 6 x 6, row by row, of x, y, z, roll, pitch, yaw. */
public final class Uncertainty {
  private static final int SIX = 6;
  private static final int PITCH = 4;
  private static final int YAW = 5;
  /** A flat covariance (a robot on the ground) is drawn as a disc of this thickness, metres. */
  private static final double THINNEST = 0.002;
  private static final double NARROWEST = Math.toRadians(0.2);
  private static final double WIDEST = Math.toRadians(80);

  private Uncertainty() {}

  /**
   * The ellipsoid of the place, around the origin of a frame parallel to that of the pose.
   *
   * @param covariance 36 numbers, or none
   * @param deviations how many standard deviations the ellipsoid reaches
   * @return one ellipsoid; none without a covariance, or where it is 0 or no number
   */
  public static Optional<Instances> position(Doubles covariance, double deviations) {
    return known(covariance)
        .flatMap(c -> Ellipsoid.of(c.get(0), c.get(1), c.get(2), c.get(SIX + 1), c.get(SIX + 2), c.get(2 * SIX + 2)))
        .filter(e -> e.deviations().norm() > 0)
        .map(e -> new Placings(1)
            .add(new RigidTransform(Vector3.ZERO, e.rotation()), wide(e.deviations().times(2 * deviations)))
            .of(Meshes.sphere()));
  }

  /**
   * The cone that the heading lies in, along the x axis of the body: as wide as yaw, as high as pitch is uncertain.
   *
   * @param covariance 36 numbers, or none
   * @param deviations how many standard deviations the cone opens to each side
   * @param length of the cone, metres
   * @return one cone; none without a covariance, or where it is 0 or no number
   */
  public static Optional<Instances> heading(Doubles covariance, double deviations, double length) {
    return known(covariance).map(c -> new double[]{c.get(YAW * SIX + YAW), c.get(PITCH * SIX + PITCH)})
        .filter(v -> Double.isFinite(v[0]) && Double.isFinite(v[1]) && (v[0] > 0 || v[1] > 0))
        .map(v -> new Vector3(length, opening(v[0], deviations, length), opening(v[1], deviations, length)))
        .map(scale -> new Placings(1).add(new RigidTransform(Vector3.ZERO, Quaternion.IDENTITY), scale)
            .of(Meshes.cone()));
  }

  private static Optional<Doubles> known(Doubles covariance) {
    return Optional.of(covariance).filter(c -> c.size() == SIX * SIX);
  }

  private static double opening(double variance, double deviations, double length) {
    return 2 * length * Math.tan(Math.clamp(Math.sqrt(Math.max(0, variance)) * deviations, NARROWEST, WIDEST));
  }

  private static Vector3 wide(Vector3 diameters) {
    return new Vector3(Math.max(THINNEST, diameters.x()), Math.max(THINNEST, diameters.y()),
        Math.max(THINNEST, diameters.z()));
  }
}
