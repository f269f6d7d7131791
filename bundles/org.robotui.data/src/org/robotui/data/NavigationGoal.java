package org.robotui.data;

import org.robotui.geometry.RigidTransform;

/**
 * Where a robot shall go.
 *
 * @param frame the frame in which it is given, usually the map
 * @param pose frame from base at the goal
 */
@Delivery(conflation = Conflation.EVENT, late = Late.NONE, expires = false)
public record NavigationGoal(FrameId frame, RigidTransform pose) implements Pose {
  /**
   * Checks the pose.
   *
   * @param frame the frame
   * @param pose frame from body
   */
  public NavigationGoal {
    Check.pose(pose, "pose");
  }
}
