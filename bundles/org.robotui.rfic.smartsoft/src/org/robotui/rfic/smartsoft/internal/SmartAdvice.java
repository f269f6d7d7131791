package org.robotui.rfic.smartsoft.internal;

import java.util.List;
import java.util.Locale;

/** What would help where a naming service is not reached: added to the reason. */
final class SmartAdvice {
  private record Hint(String sign, String help) {}

  private static final List<Hint> ALL = List.of(
      new Hint("connection refused", "start the naming service, or correct host, port or SMART_NS_ADDR"),
      new Hint("cannot be resolved", "the name of the host is not known here; write its address"),
      new Hint("timed out", "the machine is off, a firewall drops the connection, or the naming service hangs"),
      new Hint("in time", "the naming service hangs, or something else listens there"),
      new Hint("naming service of smartsoft does",
          "host and port name something else; a naming service listens on 20002 if it is not told otherwise"));

  private SmartAdvice() {}

  static String with(String reason) {
    String lower = reason.toLowerCase(Locale.ROOT);
    return ALL.stream().filter(hint -> lower.contains(hint.sign())).findFirst()
        .map(hint -> reason + "; " + hint.help()).orElse(reason);
  }
}
