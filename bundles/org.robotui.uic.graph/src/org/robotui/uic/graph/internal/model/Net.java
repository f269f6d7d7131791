package org.robotui.uic.graph.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What is to be laid out.
 *
 * @param vertices what has a box, sorted
 * @param edges what leads from one to another, sorted
 * @param frames the namespaces that are framed, outer ones first
 * @param within the frame in which a vertex or a frame lies, where it does
 * @param sizes how many nodes and topics a closed namespace holds
 */
record Net(List<Vertex> vertices, List<Edge> edges, List<Vertex> frames, Map<Vertex, Vertex> within,
    Map<Vertex, Integer> sizes) {
  static final Net EMPTY = new Net(List.of(), List.of(), List.of(), Map.of(), Map.of());

  /**
   * What leads from one box to another.
   *
   * @param from where it begins
   * @param to where it ends
   * @param topics that go along it
   */
  record Edge(Vertex from, Vertex to, Set<Vertex> topics) {}

  Optional<Vertex> frameOf(Vertex vertex) {
    return Optional.ofNullable(within.get(vertex));
  }
}
