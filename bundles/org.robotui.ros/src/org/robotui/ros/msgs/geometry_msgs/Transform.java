package org.robotui.ros.msgs.geometry_msgs;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A rotation followed by a translation ({@code geometry_msgs/Transform}).
 *
 * @param translation origin of the child frame in the parent frame, metres
 * @param rotation    orientation of the child frame in the parent frame
 */
public record Transform(Vector3 translation, Quaternion rotation) {

  /** Between records and bytes. */
  public static final RecordCodec<Transform> CODEC =
      RecordCodec.of("geometry_msgs/Transform", Transform::read, Transform::write);

  private static Transform read(MessageReader in) throws MessageException {
    return new Transform(in.nested("translation", Vector3.CODEC), in.nested("rotation", Quaternion.CODEC));
  }

  private static void write(Transform m, MessageWriter out) {
    Vector3.CODEC.encode(m.translation, out);
    Quaternion.CODEC.encode(m.rotation, out);
  }
}
