package org.robotui.data.navigation;

import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.geometry.Pose;
import org.robotui.data.geometry.Twist;
import org.robotui.data.internal.Check;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * Where a robot has moved since it started, and how fast it moves.
 *
 * @param frame frame of the pose, usually {@code odom}
 * @param childFrame frame of the twist, usually {@code base_link}
 * @param pose frame from child frame
 * @param poseCovariance 6 x 6, row by row, or none
 * @param linear velocity in the child frame, metres per second
 * @param angular velocity in the child frame, radians per second
 * @param twistCovariance 6 x 6, row by row, or none
 */
public record Odometry(
    FrameId frame,
    FrameId childFrame,
    RigidTransform pose,
    Doubles poseCovariance,
    Vector3 linear,
    Vector3 angular,
    Doubles twistCovariance)
    implements Pose, Twist {
  /** Numbers in a covariance of six dimensions. */
  public static final int COVARIANCE_SIZE = 36;

  /**
   * Checks the pose, the velocities and the sizes.
   *
   * @param frame frame of the pose
   * @param childFrame frame of the twist
   * @param pose the pose
   * @param poseCovariance none or 36 numbers
   * @param linear metres per second
   * @param angular radians per second
   * @param twistCovariance none or 36 numbers
   */
  public Odometry {
    Check.pose(pose, "pose");
    Check.that(linear.isFinite(), "linear", "must be finite, is " + linear);
    Check.that(angular.isFinite(), "angular", "must be finite, is " + angular);
    Check.emptyOr(poseCovariance.size(), COVARIANCE_SIZE, "poseCovariance");
    Check.emptyOr(twistCovariance.size(), COVARIANCE_SIZE, "twistCovariance");
  }
}
