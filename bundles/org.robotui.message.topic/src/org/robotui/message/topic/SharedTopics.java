package org.robotui.message.topic;

import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * What the robot interfaces of one type share that see the same topics: those of one server, of one partition. Safe for
 * all threads.
 *
 * @param <K> what tells their places apart, such as the address of a server
 */
public final class SharedTopics<K> {
  private final Map<K, Group> groups = new ConcurrentHashMap<>();

  /** With no interface yet. */
  public SharedTopics() {
    // Groups come with the interfaces that are in them.
  }

  /**
   * What is shared at a place.
   *
   * @param place for example the address of a server
   * @return the same for the same place
   */
  public Group of(K place) {
    return groups.computeIfAbsent(place, key -> new Group());
  }

  /** The interfaces that see the same topics. */
  public static final class Group {
    private final SharedTransforms transforms = new SharedTransforms(this::isNamespace);
    private volatile Set<String> topics = Set.of();

    private Group() {}

    /**
     * The transforms, to which one of them listens for all.
     *
     * @return always the same
     */
    public SharedTransforms transforms() {
      return transforms;
    }

    /**
     * Says which topics there are now.
     *
     * @param names each with its leading slash
     */
    public void seen(Set<String> names) {
      topics = Set.copyOf(names);
    }

    private boolean isNamespace(String name) {
      return topics.stream().anyMatch(topic -> topic.startsWith("/" + name + "/"));
    }
  }
}
