package org.robotui.ros2.graph;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.ros2.name.Ros2Name;

/**
 * A topic.
 *
 * @param name its whole name
 * @param publishers the ends that publish it
 * @param subscribers the ends that subscribe to it
 */
public record GraphTopic(Ros2Name name, List<GraphEnd> publishers, List<GraphEnd> subscribers) {

  /** Copies the lists. */
  public GraphTopic {
    publishers = List.copyOf(publishers);
    subscribers = List.copyOf(subscribers);
  }

  /**
   * The types that its ends have.
   *
   * @return usually one; sorted
   */
  public SortedSet<String> types() {
    return Stream.concat(publishers.stream(), subscribers.stream()).map(GraphEnd::typeText)
        .collect(Collectors.toCollection(TreeSet::new));
  }
}
