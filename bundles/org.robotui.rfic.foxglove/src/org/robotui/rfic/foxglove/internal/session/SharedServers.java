package org.robotui.rfic.foxglove.internal.session;

import java.net.URI;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.message.topic.SharedTransforms;

/** What the interfaces of this process share that speak to one server. Safe for all threads. */
public final class SharedServers {
  private final Map<URI, OneServer> servers = new ConcurrentHashMap<>();

  /** With no server yet. */
  public SharedServers() {
    // Servers come with the interfaces that speak to them.
  }

  /**
   * What is shared of a server.
   *
   * @param url its address
   * @return the same for the same address
   */
  public OneServer of(URI url) {
    return servers.computeIfAbsent(url, key -> new OneServer());
  }

  /** One server, as all interfaces see it that speak to it. */
  public static final class OneServer {
    private final SharedTransforms transforms = new SharedTransforms(this::isNamespace);
    private volatile Set<String> topics = Set.of();

    private OneServer() {}

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
