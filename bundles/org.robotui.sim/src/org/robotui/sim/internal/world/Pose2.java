package org.robotui.sim.internal.world;

/**
 * A place and heading in the plane.
 *
 * @param x metres
 * @param y metres
 * @param yaw radians, counter-clockwise from the x axis, kept in (-pi, pi]
 */
public record Pose2(double x, double y, double yaw) {
  public static final Pose2 ORIGIN = new Pose2(0, 0, 0);

  public Pose2 {
    yaw = Angles.wrap(yaw);
  }

  /** This pose, seen as a frame, applied to a pose given in that frame. */
  public Pose2 times(Pose2 other) {
    double c = Math.cos(yaw);
    double s = Math.sin(yaw);
    return new Pose2(x + c * other.x - s * other.y, y + s * other.x + c * other.y, yaw + other.yaw);
  }

  public Pose2 inverse() {
    double c = Math.cos(yaw);
    double s = Math.sin(yaw);
    return new Pose2(-c * x - s * y, s * x - c * y, -yaw);
  }

  public double distanceTo(Pose2 other) {
    return Math.hypot(other.x - x, other.y - y);
  }

  /** Moves along a circular arc, exact for constant speeds. */
  public Pose2 advance(double distance, double turn) {
    double middle = yaw + turn / 2;
    double chord = Math.abs(turn) < 1e-9 ? distance : distance * Math.sin(turn / 2) / (turn / 2);
    return new Pose2(x + chord * Math.cos(middle), y + chord * Math.sin(middle), yaw + turn);
  }
}
