package org.robotui.ros.msgs.trajectory_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * How joints move over time ({@code trajectory_msgs/JointTrajectory}).
 *
 * @param header     time and frame
 * @param jointNames in the order of the numbers of the points
 * @param points     in the order of time
 */
public record JointTrajectory(Header header, List<String> jointNames, List<JointTrajectoryPoint> points) {

  /** Between records and bytes. */
  public static final RecordCodec<JointTrajectory> CODEC =
      RecordCodec.of("trajectory_msgs/JointTrajectory", JointTrajectory::read, JointTrajectory::write);

  /** Keeps immutable copies of lists. */
  public JointTrajectory {
    jointNames = List.copyOf(jointNames);
    points = List.copyOf(points);
  }

  private static JointTrajectory read(MessageReader in) throws MessageException {
    return new JointTrajectory(
        in.nested("header", Header.CODEC),
        in.strings("joint_names"),
        in.list("points", JointTrajectoryPoint.CODEC));
  }

  private static void write(JointTrajectory m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    out.array(m.jointNames.size());
    m.jointNames.forEach(out::string);
    JointTrajectoryPoint.CODEC.encodeAll(m.points, out);
  }
}
