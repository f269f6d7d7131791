package org.robotui.uic.status.internal;

import java.util.Locale;
import org.robotui.api.host.PortStatus;
import org.robotui.api.port.PortKind;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;

/** Lines of ports. */
final class PortRows {
  private PortRows() {}

  static Row of(PortStatus port, boolean several) {
    String name = several ? port.port().toString() : port.port().port();
    return new Row.Item("port " + port.kind() + " " + port.port(), health(port), name, word(port), age(port), dropped(port),
        health(port) == Health.BAD ? port.problem() : port.value(), details(port));
  }

  static Health health(PortStatus port) {
    if (port.stale()) {
      return Health.STALE;
    }
    if (!port.problem().isEmpty()) {
      return Health.BAD;
    }
    if (port.kind() != PortKind.STREAM) {
      return port.wanted() ? Health.OK : Health.NONE;
    }
    if (port.count() == 0) {
      return port.wanted() ? Health.WAITING : Health.NONE;
    }
    return Health.OK;
  }

  private static String word(PortStatus port) {
    return switch (health(port)) {
      case BAD -> "failed";
      case WAITING -> "waiting";
      case STALE -> "stale";
      case NONE -> "offered";
      default -> port.rateHz() > 0 ? Figures.rate(port.rateHz()) : port.kind() == PortKind.STREAM ? "event" : "ready";
    };
  }

  private static String age(PortStatus port) {
    return Double.isNaN(port.ageSeconds()) ? "" : Figures.ageOfValue(port.ageSeconds());
  }

  private static String dropped(PortStatus port) {
    return port.dropped() > 0 ? port.dropped() + " dropped" : "";
  }

  private static String details(PortStatus port) {
    StringBuilder text = new StringBuilder(port.port() + "\n" + port.kind().name().toLowerCase(Locale.ROOT) + " of " + port.typeName());
    if (port.count() > 0) {
      text.append("\n").append(port.count()).append(" values, ").append(Figures.rate(port.rateHz())).append(", newest ")
          .append(Figures.ageOfValue(port.ageSeconds())).append(" old, ").append(port.dropped()).append(" dropped");
    }
    text.append(port.wanted() ? "" : "\nno view uses it");
    return text + (port.problem().isEmpty() ? "" : "\n" + port.problem()) + (port.value().isEmpty() ? "" : "\n" + port.value());
  }
}
