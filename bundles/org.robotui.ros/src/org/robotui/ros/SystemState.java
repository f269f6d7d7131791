package org.robotui.ros;

import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;

/**
 * Who publishes, subscribes and serves what, as the master knows it.
 *
 * @param publishers node names by topic
 * @param subscribers node names by topic
 * @param services node names by service
 */
public record SystemState(Map<String, List<String>> publishers, Map<String, List<String>> subscribers,
    Map<String, List<String>> services) {

  /** Copies the maps. */
  public SystemState {
    publishers = Map.copyOf(publishers);
    subscribers = Map.copyOf(subscribers);
    services = Map.copyOf(services);
  }

  /**
   * All nodes that are registered for anything.
   *
   * @return their global names, sorted
   */
  public SortedSet<String> nodes() {
    SortedSet<String> nodes = new TreeSet<>();
    publishers.values().forEach(nodes::addAll);
    subscribers.values().forEach(nodes::addAll);
    services.values().forEach(nodes::addAll);
    return nodes;
  }
}
