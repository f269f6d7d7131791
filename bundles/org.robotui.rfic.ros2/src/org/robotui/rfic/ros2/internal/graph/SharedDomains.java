package org.robotui.rfic.ros2.internal.graph;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.ros2.Ros2Environment;

/**
 * What the interfaces of this process share that take part in one domain: they do not take each other for robots, and
 * one listens to the transforms of all. Safe for all threads.
 */
public final class SharedDomains {
  private final Map<Ros2Environment, SharedDomain> domains = new ConcurrentHashMap<>();
  private final AtomicInteger nodes = new AtomicInteger();

  /** With no domain yet. */
  public SharedDomains() {
    // Domains come with the interfaces that take part in them.
  }

  /**
   * A domain.
   *
   * @param environment how it is entered
   * @return what is shared by those who enter it so
   */
  public SharedDomain of(Ros2Environment environment) {
    return domains.computeIfAbsent(environment, key -> new SharedDomain(nodes));
  }
}
