package org.robotui.rfic.ros2.internal.graph;

import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.message.topic.SharedTransforms;
import org.robotui.ros2.Ros2Participants;
import org.robotui.rtps.Guid;

/** One domain, as all interfaces of this process see it that take part in it. Safe for all threads. */
public final class SharedDomain {
  private final AtomicInteger nodes;
  private final Ros2Participants ours;
  private final SharedTransforms transforms = new SharedTransforms(this::isNamespace);
  private volatile Set<String> namespaces = Set.of();

  SharedDomain(AtomicInteger nodes, Ros2Participants ours) {
    this.nodes = nodes;
    this.ours = ours;
  }

  /** A name that no other node of this process has, and hardly one of another. */
  String nodeName(String begin) {
    return begin + "_" + ProcessHandle.current().pid() + "_" + nodes.incrementAndGet();
  }

  /**
   * Whether an end is one of this process: what one of our interfaces listens to, be it one on trial, is nothing that
   * the robot takes commands by.
   */
  boolean isOurs(Guid end) {
    return ours.include(end.prefix());
  }

  /** Takes note of the first parts of names in the graph. */
  void seen(Set<String> inGraph) {
    namespaces = Set.copyOf(inGraph);
  }

  private boolean isNamespace(String name) {
    return namespaces.contains(name);
  }

  /** The transforms that interfaces hear who take part. */
  SharedTransforms transforms() {
    return transforms;
  }
}
