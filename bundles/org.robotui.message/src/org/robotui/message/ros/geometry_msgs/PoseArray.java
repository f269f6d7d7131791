package org.robotui.message.ros.geometry_msgs;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

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
