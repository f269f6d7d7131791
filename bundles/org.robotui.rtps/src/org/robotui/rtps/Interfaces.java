package org.robotui.rtps;

import java.util.List;

/** Which network interfaces of this machine are used. Nothing but loopback is, unless somebody says so. */
public sealed interface Interfaces {

  /** Programs of this machine alone. */
  record Loopback() implements Interfaces {}

  /** All that are up, among them loopback. */
  record All() implements Interfaces {}

  /**
   * Some.
   *
   * @param names names of interfaces, such as {@code eth0}, or addresses of IP version 4 that they have; at least one
   */
  record Named(List<String> names) implements Interfaces {

    /** Copies the list. */
    public Named {
      names = List.copyOf(names);
      if (names.isEmpty()) {
        throw new IllegalArgumentException("at least one interface is needed");
      }
    }
  }
}
