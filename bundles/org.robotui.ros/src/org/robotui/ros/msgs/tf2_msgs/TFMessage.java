package org.robotui.ros.msgs.tf2_msgs;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.TransformStamped;

/**
 * Transforms, as {@code /tf} and {@code /tf_static} carry them ({@code tf2_msgs/TFMessage}).
 *
 * @param transforms the transforms
 */
public record TFMessage(List<TransformStamped> transforms) {

  /** Between records and bytes. */
  public static final RecordCodec<TFMessage> CODEC =
      RecordCodec.of("tf2_msgs/TFMessage", TFMessage::read, TFMessage::write);

  /** Keeps immutable copies of lists. */
  public TFMessage {
    transforms = List.copyOf(transforms);
  }

  private static TFMessage read(MessageReader in) throws MessageException {
    return new TFMessage(in.list("transforms", TransformStamped.CODEC));
  }

  private static void write(TFMessage m, MessageWriter out) {
    TransformStamped.CODEC.encodeAll(m.transforms, out);
  }
}
