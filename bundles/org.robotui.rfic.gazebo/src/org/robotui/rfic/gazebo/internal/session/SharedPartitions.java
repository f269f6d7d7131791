package org.robotui.rfic.gazebo.internal.session;

import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.message.topic.SharedTransforms;

/** What the interfaces of this process share that are in one partition. Safe for all threads. */
public final class SharedPartitions {
  private final Map<String, OnePartition> partitions = new ConcurrentHashMap<>();

  /** With none yet. */
  public SharedPartitions() {
    // Partitions come with the interfaces that are in them.
  }

  /**
   * What is shared of a partition.
   *
   * @param name of it
   * @return the same for the same name
   */
  public OnePartition of(String name) {
    return partitions.computeIfAbsent(name, key -> new OnePartition());
  }

  /** One partition, as all interfaces see it that are in it. */
  public static final class OnePartition {
    private final SharedTransforms transforms = new SharedTransforms(this::isNamespace);
    private volatile Set<String> topics = Set.of();

    private OnePartition() {}

    SharedTransforms transforms() {
      return transforms;
    }

    void seen(Set<String> names) {
      topics = Set.copyOf(names);
    }

    private boolean isNamespace(String name) {
      return topics.stream().anyMatch(topic -> topic.startsWith("/" + name + "/"));
    }
  }
}
