package org.robotui.lcm.internal.udpm;

import java.net.InetSocketAddress;
import java.util.Map;
import org.robotui.lcm.internal.client.Counters;
import org.robotui.net.collection.LruMap;

/** Who sends, and how many of their messages never came. The longest silent ones are forgotten first. */
final class Senders {

  private static final int MOST = 1024;

  private final Counters counters;
  private final Map<InetSocketAddress, Sender> known = new LruMap<>(MOST);

  Senders(Counters counters) {
    this.counters = counters;
  }

  /** A sender and the numbers of its messages. */
  private record Sender(String name, SequenceWatch sequences) {}

  /** Notes the number of a message whose first datagram came. */
  void heard(InetSocketAddress from, int sequence) {
    counters.lost(of(from).sequences().heard(sequence));
  }

  String nameOf(InetSocketAddress from) {
    return of(from).name();
  }

  private Sender of(InetSocketAddress from) {
    return known.computeIfAbsent(from, address -> new Sender(name(address), new SequenceWatch()));
  }

  static String name(InetSocketAddress from) {
    return from.getAddress().getHostAddress() + ":" + from.getPort();
  }
}
