package org.robotui.ros.msgs.geometry_msgs;

import java.util.List;

import org.robotui.ros.message.MessageType;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Several poses ({@code geometry_msgs/PoseArray}).
 *
 * @param header time and frame
 * @param poses the poses
 */
@MessageType("geometry_msgs/PoseArray")
public record PoseArray(Header header, List<Pose> poses) {

  /** Keeps immutable copies of lists. */
  public PoseArray {
    poses = List.copyOf(poses);
  }
}
