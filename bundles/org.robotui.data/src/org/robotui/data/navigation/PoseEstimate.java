package org.robotui.data.navigation;

import org.robotui.data.Delivery;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.geometry.Pose;
import org.robotui.data.internal.Check;
import org.robotui.geometry.RigidTransform;

/**
 * Where a robot is believed to be: what localisation says, or what a user tells it. It holds until the next one: a
 * localisation speaks when the robot has moved, and has nothing to say of one that stands.
 *
 * @param frame the frame in which it is given, usually the map
 * @param pose frame from base
 * @param covariance 6 x 6, row by row, of x, y, z, roll, pitch, yaw, or none where unknown
 */
@Delivery(expires = false)
public record PoseEstimate(FrameId frame, RigidTransform pose, Doubles covariance) implements Pose {
  /**
   * Checks the pose and the size of the covariance.
   *
   * @param frame the frame
   * @param pose the pose
   * @param covariance none or 36 numbers
   */
  public PoseEstimate {
    Check.pose(pose, "pose");
    Check.emptyOr(covariance.size(), Odometry.COVARIANCE_SIZE, "covariance");
  }
}
