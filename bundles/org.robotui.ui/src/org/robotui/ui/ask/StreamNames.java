package org.robotui.ui.ask;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.port.SourceId;

/**
 * Which stream carries which topic of one robot interface. Its ports are named as topics are, relative to a namespace
 * that only it knows: that under which most ports are topics.
 */
public final class StreamNames {
  private static final int ENOUGH = 200;

  private final String namespace;
  private final Map<String, SourceId> ports;

  private StreamNames(String namespace, Map<String, SourceId> ports) {
    this.namespace = namespace;
    this.ports = ports;
  }

  /**
   * Finds the namespace.
   *
   * @param topics all names of topics that the robot has
   * @param streams the ports of its interface
   * @return which is which
   */
  public static StreamNames of(Collection<String> topics, Collection<SourceId> streams) {
    Map<String, SourceId> ports = streams.stream()
        .collect(Collectors.toMap(stream -> relative(stream.port()), stream -> stream, (first, second) -> first));
    return new StreamNames(namespace(topics, ports.keySet()), ports);
  }

  /**
   * The stream of a topic.
   *
   * @param topic its name
   * @return the port that carries it, or none
   */
  public Optional<SourceId> find(String topic) {
    return topic.startsWith(namespace)
        ? Optional.ofNullable(ports.get(topic.substring(namespace.length())))
        : Optional.empty();
  }

  private static String namespace(Collection<String> topics, Set<String> ports) {
    Map<String, List<String>> byEnd = topics.stream().collect(Collectors.groupingBy(StreamNames::end));
    Map<String, Integer> votes = new HashMap<>();
    // All ports lie under one namespace: a part of them tells it.
    for (String port : ports.stream().sorted().limit(ENOUGH).toList()) {
      for (String topic : byEnd.getOrDefault(end(port), List.of())) {
        if (topic.endsWith("/" + port)) {
          votes.merge(topic.substring(0, topic.length() - port.length()), 1, Integer::sum);
        }
      }
    }
    return votes.entrySet().stream().max(StreamNames::better).map(Map.Entry::getKey).orElse("/");
  }

  /**
   * The one with more votes; of equal ones the outer, and then the first by name, so that the answer does not change.
   */
  private static int better(Map.Entry<String, Integer> one, Map.Entry<String, Integer> other) {
    int votes = Integer.compare(one.getValue(), other.getValue());
    int outer = votes != 0 ? votes : Integer.compare(other.getKey().length(), one.getKey().length());
    return outer != 0 ? outer : other.getKey().compareTo(one.getKey());
  }

  private static String end(String name) {
    return name.substring(name.lastIndexOf('/') + 1);
  }

  private static String relative(String port) {
    return port.startsWith("/") ? port.substring(1) : port;
  }
}
