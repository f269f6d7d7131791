package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.std_msgs.Header;

/**
 * A vector with time and frame ({@code geometry_msgs/Vector3Stamped}).
 *
 * @param header time and frame
 * @param vector the vector
 */
public record Vector3Stamped(Header header, Vector3 vector) {

  /** Between records and bytes. */
  public static final RecordCodec<Vector3Stamped> CODEC =
      RecordCodec.of("geometry_msgs/Vector3Stamped", Vector3Stamped::read, Vector3Stamped::write);

  private static Vector3Stamped read(MessageReader in) throws MessageException {
    return new Vector3Stamped(in.nested("header", Header.CODEC), in.nested("vector", Vector3.CODEC));
  }

  private static void write(Vector3Stamped m, MessageWriter out) {
    Header.CODEC.encode(m.header, out);
    Vector3.CODEC.encode(m.vector, out);
  }
}
