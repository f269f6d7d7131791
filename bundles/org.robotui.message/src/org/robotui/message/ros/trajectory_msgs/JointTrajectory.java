package org.robotui.message.ros.trajectory_msgs;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * How joints move over time ({@code trajectory_msgs/JointTrajectory}).
 *
 * @param header time and frame
 * @param jointNames in the order of the numbers of the points
 * @param points in the order of time
 */
@MessageType("trajectory_msgs/JointTrajectory")
public record JointTrajectory(Header header, List<String> jointNames, List<JointTrajectoryPoint> points) {

  /** Keeps immutable copies of lists. */
  public JointTrajectory {
    jointNames = List.copyOf(jointNames);
    points = List.copyOf(points);
  }
}
