package org.robotui.ros2;

import org.robotui.ros2.internal.type.DescriptionServer;

/** What a node tells others of the types of its messages (REP 2016). */
public final class Ros2Descriptions {

  private Ros2Descriptions() {}

  /**
   * Offers the service {@code ~/get_type_description}, by which those who do not know a type of this node learn it:
   * fields and defaults, but no sources and so no constants.
   *
   * @param node the node
   * @return closing it takes the service back
   * @throws IllegalStateException if the node is closed
   */
  public static Ros2ServiceServer offer(Ros2Node node) {
    return DescriptionServer.offer(node);
  }
}
