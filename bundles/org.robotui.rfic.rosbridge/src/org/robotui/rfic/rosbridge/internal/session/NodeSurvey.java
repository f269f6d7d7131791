package org.robotui.rfic.rosbridge.internal.session;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.robotui.rosbridge.RosApi.NodeDetails;

/**
 * Chooses which nodes a bridge is asked about at each look, as each question costs the robot time. Those that came last
 * are first, then those whose topics went away, then all others once after topics have changed. Where nothing changes,
 * few are asked, unless somebody looks at them. For one thread.
 */
final class NodeSurvey {
  static final int MOST_A_LOOK = 20;
  private static final int QUIET_A_LOOK = 1;
  private static final int MOST_NODES = 500;
  private static final NodeDetails UNKNOWN = new NodeDetails(List.of(), List.of(), List.of());

  private final Deque<String> urgent = new ArrayDeque<>();
  /** Who was asked, the one of the longest ago first. */
  private final Map<String, Asked> asked = new LinkedHashMap<>();
  private Set<String> topics = Set.of();
  private Set<String> names = Set.of();
  private int look;
  private int changed;
  private int most;
  private int count;

  /** What a node does, and at which look it was said. */
  private record Asked(NodeDetails details, int look) {
    Stream<String> topics() {
      return Stream.concat(details.publishing().stream(), details.subscribing().stream());
    }
  }

  /** Begins a look at what there is now. */
  void begin(Collection<String> topicsNow, List<String> namesNow, boolean looked) {
    look++;
    count = 0;
    most = looked ? MOST_A_LOOK : QUIET_A_LOOK;
    Set<String> gone = new HashSet<>(topics);
    gone.removeAll(topicsNow);
    changed = Set.copyOf(topicsNow).equals(topics) ? changed : look;
    topics = Set.copyOf(topicsNow);
    names = Set.copyOf(namesNow.stream().limit(MOST_NODES).toList());
    asked.keySet().retainAll(names);
    urgent.retainAll(names);
    asked.forEach((name, known) -> {
      if (known.topics().anyMatch(gone::contains)) {
        first(name);
      }
    });
    names.stream().filter(name -> !asked.containsKey(name) && !urgent.contains(name)).forEach(urgent::addFirst);
  }

  private void first(String name) {
    urgent.remove(name);
    urgent.addFirst(name);
  }

  /** Whom to ask next; none where it is enough for this look. */
  Optional<String> next() {
    Optional<String> chosen = count >= MOST_A_LOOK ? Optional.empty()
        : Optional.ofNullable(urgent.poll()).or(this::oldest);
    count++;
    return chosen;
  }

  private Optional<String> oldest() {
    return asked.entrySet().stream().findFirst().filter(first -> first.getValue().look() < look)
        .filter(first -> first.getValue().look() < changed || count < most).map(Map.Entry::getKey);
  }

  /** Takes the answer; none where the node gave none, as others have their turn. */
  void answered(String name, Optional<NodeDetails> details) {
    asked.remove(name);
    asked.put(name, new Asked(details.orElse(UNKNOWN), look));
  }

  /** All nodes; those not asked yet do nothing. */
  Map<String, NodeDetails> nodes() {
    Map<String, NodeDetails> nodes = new TreeMap<>();
    names.forEach(name -> nodes.put(name, Optional.ofNullable(asked.get(name)).map(Asked::details).orElse(UNKNOWN)));
    return nodes;
  }
}
