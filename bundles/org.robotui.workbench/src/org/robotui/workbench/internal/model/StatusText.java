package org.robotui.workbench.internal.model;

import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.time.RobotClock;
import org.robotui.data.ClockKind;
import org.robotui.ui.Figures;

/**
 * What the status line says of the robot that a window shows.
 *
 * @param left which robot
 * @param right clock and traffic
 */
public record StatusText(String left, String right) {
  /** Where a window shows no robot. */
  public static final StatusText NONE = new StatusText("no robot selected", "");

  /** No clock of a robot that runs is this far off. */
  private static final Duration MOST_OFFSET = Duration.ofDays(2);
  private static final String DOT = " \u00b7 ";

  /** Makes the line. */
  public static StatusText of(RuicSnapshot ruic, RobotClock clock) {
    String frameworks = RobotRow.frameworks(ruic);
    String left = ruic.name() + (frameworks.isEmpty() ? "" : DOT + frameworks) + DOT + ruic.link().word();
    return new StatusText(left, clock(clock) + DOT + traffic(ruic));
  }

  private static String clock(RobotClock clock) {
    if (clock.kind() == ClockKind.SIMULATED || clock.kind() == ClockKind.REPLAY) {
      return clock.kind().name().toLowerCase(Locale.ROOT) + " time";
    }
    Optional<Duration> offset = clock.offset();
    Optional<Duration> far = offset.filter(o -> o.abs().compareTo(MOST_OFFSET) > 0);
    if (far.isPresent()) {
      return "time stamps " + far.get().abs().toDays() + " days "
          + (far.get().isNegative() ? "old: a recording?" : "ahead: is a clock wrong?");
    }
    return "clock offset " + offset.map(StatusText::signed).orElse("unknown");
  }

  private static String signed(Duration offset) {
    double seconds = offset.toNanos() * 1e-9;
    return (seconds > 0 ? "+" : "") + Figures.age(seconds);
  }

  private static String traffic(RuicSnapshot ruic) {
    double rate = ruic.ports().stream().mapToDouble(PortStatus::rateHz).filter(r -> r > 0).sum();
    long dropped = ruic.ports().stream().mapToLong(PortStatus::dropped).sum();
    return "received " + Figures.of(rate, 0, "msg/s") + DOT + "dropped " + dropped;
  }
}
