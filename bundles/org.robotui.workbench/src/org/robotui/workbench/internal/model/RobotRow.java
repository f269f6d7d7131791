package org.robotui.workbench.internal.model;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.PortKind;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;

/**
 * A robot in the navigator: is it alive, and the one number that matters.
 *
 * @param name the RUIC
 * @param health the dot
 * @param figure rate of the busiest wanted port, or the word that says why there is none
 * @param second frameworks and peer, or why it does not work
 */
public record RobotRow(String name, Health health, String figure, String second) {
  /** Makes the row of a snapshot. */
  public static RobotRow of(RuicSnapshot ruic) {
    return new RobotRow(ruic.name(), health(ruic), figure(ruic), second(ruic));
  }

  private static Health health(RuicSnapshot ruic) {
    if (ruic.state() == RuicState.FAILED) {
      return Health.BAD;
    }
    return switch (ruic.link()) {
      case LinkState.Failed f -> Health.BAD;
      case LinkState.Degraded d -> Health.WARNING;
      case LinkState.Connecting c -> Health.WAITING;
      case LinkState.Disconnected d -> Health.NONE;
      case LinkState.Connected c -> connectedHealth(ruic);
    };
  }

  private static Health connectedHealth(RuicSnapshot ruic) {
    if (stale(ruic) > 0) {
      return Health.STALE;
    }
    boolean failed = ruic.components().stream().anyMatch(c -> c.state() == RuicState.FAILED);
    if (failed || wanted(ruic).stream().anyMatch(p -> !p.problem().isEmpty())) {
      return Health.WARNING;
    }
    return wanted(ruic).stream().anyMatch(p -> p.count() > 0) ? Health.OK : Health.WAITING;
  }

  private static String figure(RuicSnapshot ruic) {
    if (ruic.state() == RuicState.FAILED) {
      return "failed";
    }
    if (ruic.state() == RuicState.ADDED) {
      return "not open";
    }
    if (!(ruic.link() instanceof LinkState.Connected) && !(ruic.link() instanceof LinkState.Degraded)) {
      return ruic.link().word();
    }
    long stale = stale(ruic);
    return stale > 0 ? stale + " stale" : busiest(ruic);
  }

  private static String busiest(RuicSnapshot ruic) {
    return wanted(ruic).stream()
        .max(Comparator.comparingDouble(PortStatus::rateHz))
        .filter(p -> p.rateHz() > 0)
        .map(p -> Figures.of(p.rateHz(), p.rateHz() < 10 ? 1 : 0, "Hz"))
        .orElse("no data");
  }

  private static String second(RuicSnapshot ruic) {
    if (!ruic.reason().isEmpty()) {
      return ruic.reason();
    }
    String frameworks = frameworks(ruic);
    String peer = switch (ruic.link()) {
      case LinkState.Connected c -> shortened(c.peer());
      case LinkState.Degraded d -> d.reason();
      default -> ruic.link().reason();
    };
    return frameworks.isEmpty() || peer.isEmpty() ? frameworks + peer : frameworks + " \u00b7 " + peer;
  }

  /** The frameworks that the robot speaks, for example {@code ros, lcm}. */
  public static String frameworks(RuicSnapshot ruic) {
    return ruic.components().stream()
        .filter(c -> c.kind() == ComponentStatus.Kind.RFIC)
        .map(ComponentStatus::type)
        .distinct()
        .collect(Collectors.joining(", "));
  }

  /** A peer without the parts that are the same for all: {@code http://localhost:11411/} becomes {@code :11411}. */
  static String shortened(String peer) {
    String host = peer.replaceFirst("^[a-z][a-z0-9+.-]*://", "").replaceFirst("/$", "");
    return host.replaceFirst("^(localhost|127\\.0\\.0\\.1|\\[::1])(?=:)", "");
  }

  private static long stale(RuicSnapshot ruic) {
    return wanted(ruic).stream().filter(PortStatus::stale).count();
  }

  private static List<PortStatus> wanted(RuicSnapshot ruic) {
    return ruic.ports().stream().filter(p -> p.kind() == PortKind.STREAM && p.wanted()).toList();
  }
}
