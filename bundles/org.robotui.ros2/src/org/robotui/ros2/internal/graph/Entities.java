package org.robotui.ros2.internal.graph;

import java.util.List;
import org.robotui.rtps.Guid;

/**
 * Which nodes a participant has, and which readers and writers they have, as it says on {@code ros_discovery_info}.
 *
 * @param participant which participant
 * @param nodes its nodes
 */
public record Entities(Guid participant, List<Node> nodes) {

  /**
   * A node.
   *
   * @param namespace its namespace
   * @param name its base name
   * @param readers what it reads with
   * @param writers what it writes with
   */
  public record Node(String namespace, String name, List<Guid> readers, List<Guid> writers) {}
}
