package org.robotui.message.ros.tf;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.TransformStamped;

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
