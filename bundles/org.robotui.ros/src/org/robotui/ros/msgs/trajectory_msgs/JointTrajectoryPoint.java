package org.robotui.ros.msgs.trajectory_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.message.Stamps;

/**
 * What joints do at a time ({@code trajectory_msgs/JointTrajectoryPoint}).
 *
 * @param positions     one a joint, radians or metres; or none
 * @param velocities    one a joint, per second; or none
 * @param accelerations one a joint, per second squared; or none
 * @param effort        one a joint, newton metres or newton; or none
 * @param timeFromStart nanoseconds since the start
 */
public record JointTrajectoryPoint(
    double[] positions,
    double[] velocities,
    double[] accelerations,
    double[] effort,
    long timeFromStart) {

  /** Between records and bytes. */
  public static final RecordCodec<JointTrajectoryPoint> CODEC =
      RecordCodec.of("trajectory_msgs/JointTrajectoryPoint", JointTrajectoryPoint::read, JointTrajectoryPoint::write);

  private static JointTrajectoryPoint read(MessageReader in) throws MessageException {
    return new JointTrajectoryPoint(
        in.doubles("positions", in.count("positions", Double.BYTES)),
        in.doubles("velocities", in.count("velocities", Double.BYTES)),
        in.doubles("accelerations", in.count("accelerations", Double.BYTES)),
        in.doubles("effort", in.count("effort", Double.BYTES)),
        in.duration("time_from_start"));
  }

  private static void write(JointTrajectoryPoint m, MessageWriter out) {
    out.array(m.positions.length).doubles(m.positions);
    out.array(m.velocities.length).doubles(m.velocities);
    out.array(m.accelerations.length).doubles(m.accelerations);
    out.array(m.effort.length).doubles(m.effort);
    Stamps.write(m.timeFromStart, out);
  }
}
