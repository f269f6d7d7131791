package org.robotui.data;

import java.util.List;
import org.robotui.geometry.RigidTransform;

/**
 * A way through space.
 *
 * @param frame frame of the poses
 * @param poses frame from body along the way, first to last; empty where there is no way
 */
@Delivery(expires = false)
public record Path(FrameId frame, List<RigidTransform> poses) implements Data, InFrame {
  /**
   * Copies the list and checks the poses.
   *
   * @param frame the frame
   * @param poses the poses
   */
  public Path {
    poses = List.copyOf(poses);
    Check.poses(poses, "poses");
  }
}
