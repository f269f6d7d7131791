package org.robotui.uic.graph.internal.model;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.uic.graph.internal.model.Vertex.Kind;
import org.robotui.uic.graph.internal.model.Wiring.Tie;

/**
 * Topics that are wired alike: the same nodes publish them, and the same subscribe. Many of them say no more than one
 * box does, and would make all others too small to read.
 *
 * @param groups by topic, of those that have many like them
 */
record Alike(Map<Vertex, Vertex> groups) {
  /** As many may be wired alike before they share a box. */
  static final int MOST = 12;
  private static final int MOST_NODES = 3;

  /** What one topic is wired to. */
  private record Ends(String robot, Set<String> from, Set<String> to) {
    String name() {
      String senders = String.join(", ", from.stream().sorted().toList());
      String receivers = String.join(", ", to.stream().sorted().toList());
      return from.isEmpty() ? "topics to " + receivers
          : to.isEmpty() ? "topics of " + senders : "topics from " + senders + " to " + receivers;
    }

    boolean few() {
      return from.size() + to.size() <= MOST_NODES;
    }
  }

  static Alike of(Collection<Tie> ties) {
    Map<Vertex, List<Tie>> byTopic = ties.stream().collect(Collectors.groupingBy(Tie::topic));
    Map<Ends, List<Vertex>> byEnds = new HashMap<>();
    byTopic.forEach((topic, its) -> byEnds.computeIfAbsent(ends(topic, its), e -> new ArrayList<>()).add(topic));
    Map<Vertex, Vertex> groups = new HashMap<>();
    byEnds.forEach((ends, topics) -> {
      if (topics.size() > MOST && ends.few()) {
        topics.forEach(topic -> groups.put(topic, new Vertex(Kind.GROUP, ends.robot(), ends.name())));
      }
    });
    return new Alike(Map.copyOf(groups));
  }

  Optional<Vertex> groupOf(Vertex vertex) {
    return Optional.ofNullable(groups.get(vertex));
  }

  private static Ends ends(Vertex topic, List<Tie> ties) {
    Set<String> from = new HashSet<>();
    Set<String> to = new HashSet<>();
    ties.forEach(tie -> (tie.sends() ? from : to).add(tie.node().name()));
    return new Ends(topic.robot(), from, to);
  }
}
