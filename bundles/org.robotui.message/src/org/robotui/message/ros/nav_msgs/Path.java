package org.robotui.message.ros.nav_msgs;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.PoseStamped;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Poses to follow or followed ({@code nav_msgs/Path}).
 *
 * @param header time and frame
 * @param poses in order
 */
@MessageType("nav_msgs/Path")
public record Path(Header header, List<PoseStamped> poses) {

  /** Keeps immutable copies of lists. */
  public Path {
    poses = List.copyOf(poses);
  }
}
