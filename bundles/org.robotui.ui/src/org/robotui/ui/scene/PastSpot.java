package org.robotui.ui.scene;

import java.util.List;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * Where a robot was at the time at which the user points.
 *
 * @param frame the frame in which the recording says that
 * @param pose of the robot in the frame
 * @param way all of the way that the recording has, in the frame; the same list for all times
 */
public record PastSpot(FrameId frame, RigidTransform pose, List<Vector3> way) {
  /**
   * Copies the list, where it is not one that stays.
   *
   * @param frame of the pose
   * @param pose of the robot
   * @param way of the robot
   */
  public PastSpot {
    way = List.copyOf(way);
  }
}
