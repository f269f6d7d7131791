package org.robotui.ros.msgs.tf;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.geometry_msgs.TransformStamped;

/**
 * Transforms, the old type of {@code /tf} ({@code tf/tfMessage}).
 *
 * @param transforms the transforms
 */
public record TfMessage(List<TransformStamped> transforms) {

  /** Between records and bytes. */
  public static final RecordCodec<TfMessage> CODEC =
      RecordCodec.of("tf/tfMessage", TfMessage::read, TfMessage::write);

  /** Keeps immutable copies of lists. */
  public TfMessage {
    transforms = List.copyOf(transforms);
  }

  private static TfMessage read(MessageReader in) throws MessageException {
    return new TfMessage(in.list("transforms", TransformStamped.CODEC));
  }

  private static void write(TfMessage m, MessageWriter out) {
    TransformStamped.CODEC.encodeAll(m.transforms, out);
  }
}
