package org.robotui.ros.internal.node;

import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentMap;
import org.robotui.ros.UnregisterHandler;

/** Leaves, for each registration, what shall be said to the master if this process cannot. Safe for all threads. */
final class UnregisterCalls {

  private final UnregisterHandler farewells;
  private final RosApi master;
  private final ConcurrentMap<Registration, Runnable> left = new ConcurrentHashMap<>();

  UnregisterCalls(UnregisterHandler farewells, RosApi master) {
    this.farewells = farewells;
    this.master = master;
  }

  /** Before the master hears of it. */
  void leave(Registration registration) {
    registration.farewell().ifPresent(call -> left.computeIfAbsent(registration, key -> {
      InetSocketAddress address = new InetSocketAddress(master.target().host(), master.target().port());
      return address.isUnresolved() ? () -> {} : farewells.leave(address, master.words(call));
    }));
  }

  /** When the master does not know it any more. */
  void withdraw(Registration registration) {
    Optional.ofNullable(left.remove(registration)).ifPresent(Runnable::run);
  }

  /** When the node is closed. */
  void withdrawAll() {
    left.keySet().forEach(this::withdraw);
  }
}
