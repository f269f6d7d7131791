package org.robotui.uic.graph.internal.model;

import java.util.List;

/**
 * What has a box: a node, a topic, or a closed namespace.
 *
 * @param kind what it is
 * @param robot the component that offers to be browsed
 * @param name the robot's name for it
 */
public record Vertex(Kind kind, String robot, String name) {
  /** What has a box. */
  public enum Kind {
    /** A program. */
    NODE,
    /** A topic. */
    TOPIC,
    /** A namespace, closed to one box or drawn as a frame. */
    GROUP
  }

  /** The segments of the name. */
  List<String> segments() {
    return List.of((name.startsWith("/") ? name.substring(1) : name).split("/"));
  }
}
