package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A force and a torque ({@code geometry_msgs/Wrench}).
 *
 * @param force  newtons
 * @param torque newton metres
 */
public record Wrench(Vector3 force, Vector3 torque) {

  /** Between records and bytes. */
  public static final RecordCodec<Wrench> CODEC =
      RecordCodec.of("geometry_msgs/Wrench", Wrench::read, Wrench::write);

  private static Wrench read(MessageReader in) throws MessageException {
    return new Wrench(in.nested("force", Vector3.CODEC), in.nested("torque", Vector3.CODEC));
  }

  private static void write(Wrench m, MessageWriter out) {
    Vector3.CODEC.encode(m.force, out);
    Vector3.CODEC.encode(m.torque, out);
  }
}
