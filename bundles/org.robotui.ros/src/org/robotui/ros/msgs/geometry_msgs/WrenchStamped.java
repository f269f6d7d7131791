package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A force and a torque with time and frame ({@code geometry_msgs/WrenchStamped}).
 *
 * @param header time and frame
 * @param wrench the force and the torque
 */
public record WrenchStamped(Header header, Wrench wrench) {

  /** Between records and bytes. */
  public static final RecordCodec<WrenchStamped> CODEC =
      RecordCodec.of("geometry_msgs/WrenchStamped", WrenchStamped::read, WrenchStamped::write);

  private static WrenchStamped read(MessageReader in) throws MessageException {
    return new WrenchStamped(in.nested("header", Header.CODEC), in.nested("wrench", Wrench.CODEC));
  }

  private static void write(WrenchStamped m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Wrench.CODEC.encode(m.wrench, out);
  }
}
