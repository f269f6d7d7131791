package org.robotui.data.navigation;

import org.robotui.data.Conflation;
import org.robotui.data.Delivery;
import org.robotui.data.FrameId;
import org.robotui.data.Late;
import org.robotui.data.geometry.Pose;
import org.robotui.data.internal.Check;
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
