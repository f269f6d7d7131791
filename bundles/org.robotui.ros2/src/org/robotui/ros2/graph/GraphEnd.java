package org.robotui.ros2.graph;

import java.util.Optional;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Qos;

/**
 * One end of a topic or service.
 *
 * @param guid the writer or reader
 * @param node its node; empty while its process has not said which it is, or does not know nodes
 * @param type its type, as far as it is one of ROS 2
 * @param typeText the name of its type, for a user to read: that of ROS 2, or else that of DDS
 * @param hash the sum of its type, which nobody announces before Iron
 * @param qos what it offers or requests
 * @param own whether it is of this context
 */
public record GraphEnd(Guid guid, Optional<Ros2Name> node, Optional<TypeName> type, String typeText,
    Optional<TypeHash> hash, Qos qos, boolean own) {

  /**
   * The end as a user knows it.
   *
   * @return the name of its node, or its own
   */
  public String who() {
    return node.map(Ros2Name::text).orElseGet(guid::toString);
  }
}
