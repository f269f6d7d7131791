package org.robotui.rfic.ros2.internal.graph;

import java.io.IOException;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Options;
import org.robotui.ros2.Ros2Participants;

/**
 * What the interfaces of this process share that take part in one domain: they do not take each other for robots, and
 * one listens to the transforms of all. Those that enter a domain in the same way are one participant there. Safe for
 * all threads.
 */
public final class SharedDomains {
  private final Map<Ros2Environment, SharedDomain> domains = new ConcurrentHashMap<>();
  private final AtomicInteger nodes = new AtomicInteger();
  private final Ros2Participants participants = new Ros2Participants(new OutlivingThreads());

  /** With no domain yet. */
  public SharedDomains() {
    // Domains come with the interfaces that take part in them.
  }

  /**
   * Takes part in a domain.
   *
   * @param environment how it is entered
   * @param options what the interface gives its context
   * @return the open context
   * @throws IOException if a socket cannot be opened
   */
  public Ros2Context open(Ros2Environment environment, Ros2Options options) throws IOException {
    return participants.open(environment, options);
  }

  /**
   * A domain.
   *
   * @param environment how it is entered
   * @return what is shared by those who enter it so
   */
  public SharedDomain of(Ros2Environment environment) {
    return domains.computeIfAbsent(environment, key -> new SharedDomain(nodes, participants));
  }
}
