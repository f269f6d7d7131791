package org.robotui.data.geometry;

import java.util.List;
import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;
import org.robotui.data.internal.Check;
import org.robotui.geometry.RigidTransform;

/**
 * Many poses at one time, in no order that means something: the particles of a localisation, grasps to choose from.
 *
 * @param frame frame of the poses
 * @param poses frame from body each
 */
@Delivery(expires = false)
public record PoseArray(FrameId frame, List<RigidTransform> poses) implements Data, InFrame {
  /**
   * Copies the list and checks the poses.
   *
   * @param frame the frame
   * @param poses the poses
   */
  public PoseArray {
    poses = List.copyOf(poses);
    Check.poses(poses, "poses");
  }
}
