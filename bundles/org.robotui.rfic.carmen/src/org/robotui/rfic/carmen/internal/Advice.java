package org.robotui.rfic.carmen.internal;

import java.util.List;
import java.util.Locale;

/** What would help where a central is not reached: added to the reason. */
final class Advice {
  private record Hint(String sign, String help) {}

  private static final List<Hint> ALL = List.of(
      new Hint("connection refused", "start it (central), or correct host, port or CENTRALHOST"),
      new Hint("no central",
          "host and port name something else; a central listens on 1381 if it is not told otherwise"),
      new Hint("cannot be resolved", "the name of the host is not known here; write its address"),
      new Hint("timed out", "the machine is off, a firewall drops the connection, or the central hangs"),
      new Hint("in time", "the central hangs, or something else listens there"),
      new Hint("not answered within", "the central hangs, or the network is cut"));

  private Advice() {}

  static String with(String reason) {
    String lower = reason.toLowerCase(Locale.ROOT);
    return ALL.stream().filter(hint -> lower.contains(hint.sign())).findFirst()
        .map(hint -> reason + "; " + hint.help()).orElse(reason);
  }
}
