package org.robotui.ros.msgs.tf;

import java.util.List;

import org.robotui.ros.message.MessageType;
import org.robotui.ros.msgs.geometry_msgs.TransformStamped;

/**
 * Transforms, the old type of {@code /tf} ({@code tf/tfMessage}).
 *
 * @param transforms the transforms
 */
@MessageType("tf/tfMessage")
public record TfMessage(List<TransformStamped> transforms) {

  /** Keeps immutable copies of lists. */
  public TfMessage {
    transforms = List.copyOf(transforms);
  }
}
