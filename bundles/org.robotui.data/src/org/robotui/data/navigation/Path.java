package org.robotui.data.navigation;

import java.util.List;
import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;
import org.robotui.data.internal.Check;
import org.robotui.geometry.RigidTransform;

/**
 * A path through space.
 *
 * @param frame frame of the poses
 * @param poses frame from body along the path, first to last; empty where there is no path
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
