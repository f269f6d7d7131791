package org.robotui.rfic.player.internal.link;

import java.util.List;
import java.util.Locale;

/** What would help where a server is not reached: added to the reason, as users seldom know Player's ways. */
final class Remedies {
  private record Remedy(String sign, String help) {}

  private static final List<Remedy> ALL = List.of(
      new Remedy("no player server",
          "host and port name something else; a Player server listens on 6665 if it is not told otherwise"),
      new Remedy("does not take the key", "write the key that the server was started with (player -k)"),
      new Remedy("may want a key", "write its key, if it was started with one (player -k)"),
      new Remedy("connection refused",
          "start it (player robot.cfg), or correct host, port, PLAYER_HOST or PLAYER_PORT"),
      new Remedy("unresolved", "the name of the host is not known here; write its address"),
      new Remedy("unknown host", "the name of the host is not known here; write its address"),
      new Remedy("timed out", "the machine is off, a firewall drops the connection, or the server hangs"),
      new Remedy("in time", "the server hangs, or something else listens there"),
      new Remedy("no route", "the robot's network is not reached from this machine"),
      new Remedy("unreachable", "the robot's network is not reached from this machine"));

  private Remedies() {}

  static String with(String reason) {
    String lower = reason.toLowerCase(Locale.ROOT);
    return ALL.stream().filter(r -> lower.contains(r.sign())).findFirst().map(r -> reason + "; " + r.help())
        .orElse(reason);
  }
}
