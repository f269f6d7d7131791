package org.robotui.message.ros.sensor_msgs;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.std_msgs.Header;

/**
 * Positions, velocities and efforts of joints ({@code sensor_msgs/JointState}).
 *
 * @param header time
 * @param name the joints
 * @param position radians or metres for each joint, or empty
 * @param velocity radians or metres per second for each joint, or empty
 * @param effort newton metres or newtons for each joint, or empty
 */
@MessageType("sensor_msgs/JointState")
public record JointState(Header header, List<String> name, double[] position, double[] velocity, double[] effort) {

  /** Keeps immutable copies of lists. */
  public JointState {
    name = List.copyOf(name);
  }
}
