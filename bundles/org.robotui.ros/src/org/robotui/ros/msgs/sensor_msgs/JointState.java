package org.robotui.ros.msgs.sensor_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * Positions, velocities and efforts of joints ({@code sensor_msgs/JointState}).
 *
 * @param header   time
 * @param name     the joints
 * @param position radians or metres for each joint, or empty
 * @param velocity radians or metres per second for each joint, or empty
 * @param effort   newton metres or newtons for each joint, or empty
 */
public record JointState(Header header, List<String> name, double[] position, double[] velocity, double[] effort) {

  /** Between records and bytes. */
  public static final RecordCodec<JointState> CODEC =
      RecordCodec.of("sensor_msgs/JointState", JointState::read, JointState::write);

  /** Keeps immutable copies of lists. */
  public JointState {
    name = List.copyOf(name);
  }

  private static JointState read(MessageReader in) throws MessageException {
    return new JointState(
        in.nested("header", Header.CODEC),
        in.strings("name"),
        in.doubles("position", in.count("position", 8)),
        in.doubles("velocity", in.count("velocity", 8)),
        in.doubles("effort", in.count("effort", 8)));
  }

  private static void write(JointState m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.array(m.name.size());
    m.name.forEach(out::string);
    out.array(m.position.length).doubles(m.position);
    out.array(m.velocity.length).doubles(m.velocity);
    out.array(m.effort.length).doubles(m.effort);
  }
}
