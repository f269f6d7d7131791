package org.robotui.rfic.ros.internal.graph;

import java.net.URI;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * What the interfaces of this process share that speak to one master: where many robots are at one, each would
 * otherwise ask for the same graph, listen to the transforms of all, and remove what all left. Safe for all threads.
 */
public final class SharedMasters {
  private final Map<URI, SharedMaster> masters = new ConcurrentHashMap<>();
  private final SharedCleanup sweep = new SharedCleanup();

  /** With no master yet. */
  public SharedMasters() {
    // Masters come with the interfaces that speak to them.
  }

  /** Removes what earlier runs left at all of them. */
  public SharedCleanup sweep() {
    return sweep;
  }

  SharedMaster of(URI uri) {
    return masters.computeIfAbsent(uri, key -> new SharedMaster());
  }
}
