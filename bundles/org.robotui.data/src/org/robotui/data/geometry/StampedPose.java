package org.robotui.data.geometry;

import org.robotui.data.FrameId;
import org.robotui.data.internal.Check;
import org.robotui.geometry.RigidTransform;

/**
 * A pose as such.
 *
 * @param frame the frame in which it is given
 * @param pose frame from body
 */
public record StampedPose(FrameId frame, RigidTransform pose) implements Pose {
  /**
   * Checks the pose.
   *
   * @param frame the frame
   * @param pose frame from body
   */
  public StampedPose {
    Check.pose(pose, "pose");
  }
}
