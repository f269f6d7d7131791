package org.robotui.rosbridge;

import java.nio.ByteBuffer;
import java.util.Map;

/** A message of a topic, as the bridge sent it. */
public sealed interface BridgeMessage {

  /**
   * By the names of its fields.
   *
   * @param fields a tree of plain values
   */
  record Tree(Map<String, Object> fields) implements BridgeMessage {}

  /**
   * As it was serialized for ROS: of the bridge's generation, that of ROS 1 or CDR.
   *
   * @param bytes the whole message; nobody writes to it again
   */
  record Raw(ByteBuffer bytes) implements BridgeMessage {}
}
