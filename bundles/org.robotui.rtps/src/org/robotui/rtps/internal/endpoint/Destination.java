package org.robotui.rtps.internal.endpoint;

import java.net.InetSocketAddress;
import java.util.List;
import org.robotui.rtps.GuidPrefix;

/**
 * Where the ends of another participant are reached.
 *
 * @param participant whose ends they are
 * @param addresses each gets every datagram
 * @param mostDatagram no datagram to it is longer, in bytes
 */
public record Destination(GuidPrefix participant, List<InetSocketAddress> addresses, int mostDatagram) {

  /** What a header, its time, its destination and the submessage around a fragment take, at most. */
  private static final int AROUND_FRAGMENT = 144;

  /** Keeps a list of its own. */
  public Destination {
    addresses = List.copyOf(addresses);
  }

  /** A payload longer than this is sent in fragments of this size. */
  int fragmentSize() {
    return mostDatagram - AROUND_FRAGMENT;
  }
}
