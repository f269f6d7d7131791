package org.robotui.ui;

import java.util.Locale;
import org.robotui.api.host.PortStatus;
import org.robotui.api.port.PortKind;

/** How ports of robot interfaces look, the same in all views that list them. Pure, for all threads. */
public final class PortLook {
  private PortLook() {}

  /**
   * The dot of a port.
   *
   * @param port the port
   * @return its health; none where no view uses it
   */
  public static Health health(PortStatus port) {
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

  /**
   * The word of a port.
   *
   * @param port the port
   * @return its rate where it has one, else for example {@code waiting}
   */
  public static String word(PortStatus port) {
    return switch (health(port)) {
      case BAD -> "failed";
      case WAITING -> "waiting";
      case STALE -> "stale";
      case NONE -> "offered";
      default -> port.rateHz() > 0 ? Figures.rate(port.rateHz()) : port.kind() == PortKind.STREAM ? "event" : "ready";
    };
  }

  /**
   * How old its newest value is.
   *
   * @param port the port
   * @return for example {@code 12 ms}, or empty before the first
   */
  public static String age(PortStatus port) {
    return Double.isNaN(port.ageSeconds()) ? "" : Figures.ageOfValue(port.ageSeconds());
  }

  /**
   * What was lost.
   *
   * @param port the port
   * @return for example {@code 14 dropped}, or empty where nothing was
   */
  public static String dropped(PortStatus port) {
    return port.dropped() > 0 ? port.dropped() + " dropped" : "";
  }

  /**
   * What is to be said of a port: its problem, else its newest value.
   *
   * @param port the port
   * @return a short text, or empty
   */
  public static String text(PortStatus port) {
    return health(port) == Health.BAD ? port.problem() : port.value();
  }

  /**
   * Everything about a port, for tooltip and clipboard.
   *
   * @param port the port
   * @return several lines
   */
  public static String details(PortStatus port) {
    StringBuilder text =
        new StringBuilder(port.port() + "\n" + port.kind().name().toLowerCase(Locale.ROOT) + " of " + port.typeName());
    if (port.count() > 0) {
      text.append("\n").append(port.count()).append(" values, ").append(Figures.rate(port.rateHz())).append(", newest ")
          .append(Figures.ageOfValue(port.ageSeconds())).append(" old, ").append(port.dropped()).append(" dropped");
    }
    text.append(port.delivery().isEmpty() ? "" : "\n" + port.delivery());
    text.append(port.wanted() ? "" : "\nno view uses it");
    return text + (port.problem().isEmpty() ? "" : "\n" + port.problem())
        + (port.value().isEmpty() ? "" : "\n" + port.value());
  }
}
