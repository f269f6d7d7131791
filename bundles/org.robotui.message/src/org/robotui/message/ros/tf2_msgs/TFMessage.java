package org.robotui.message.ros.tf2_msgs;

import java.util.List;

import org.robotui.message.MessageType;
import org.robotui.message.ros.geometry_msgs.TransformStamped;

/**
 * Transforms, as {@code /tf} and {@code /tf_static} carry them ({@code tf2_msgs/TFMessage}).
 *
 * @param transforms the transforms
 */
@MessageType("tf2_msgs/TFMessage")
public record TFMessage(List<TransformStamped> transforms) {

  /** Keeps immutable copies of lists. */
  public TFMessage {
    transforms = List.copyOf(transforms);
  }
}
