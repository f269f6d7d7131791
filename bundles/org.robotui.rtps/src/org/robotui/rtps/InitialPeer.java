package org.robotui.rtps;

import java.util.OptionalInt;

/**
 * A machine that is asked for participants although it may not hear multicast.
 *
 * @param host its name or address
 * @param port one port; without it those of the first participants of a machine are tried
 */
public record InitialPeer(String host, OptionalInt port) {

  /** Checks the bounds. */
  public InitialPeer {
    if (host.isBlank() || port.isPresent() && (port.getAsInt() < 1 || port.getAsInt() > 0xffff)) {
      throw new IllegalArgumentException("no peer: '" + host + "', port " + port);
    }
  }
}
