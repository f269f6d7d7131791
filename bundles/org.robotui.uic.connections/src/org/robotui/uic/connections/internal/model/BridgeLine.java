package org.robotui.uic.connections.internal.model;

import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;

/**
 * A way of a bridge, at one of its ends.
 *
 * @param end at which it is listed
 * @param bridge how it is doing
 */
public record BridgeLine(BridgeEnd end, BridgeStatus bridge) implements ConnectionLine {
  private static final double MILLIS = 1e3;

  private boolean leads() {
    return end.equals(bridge.from());
  }

  @Override
  public String key() {
    return ruic() + "\nBRIDGE " + bridge.from() + " " + bridge.to() + " " + leads();
  }

  @Override
  public String ruic() {
    return end.ruic();
  }

  @Override
  public Health health() {
    return switch (bridge.state()) {
      case CARRYING -> Health.OK;
      case WAITING -> Health.WAITING;
      case REFUSED -> Health.WARNING;
      case WRONG -> Health.BAD;
    };
  }

  private BridgeEnd other() {
    return leads() ? bridge.to() : bridge.from();
  }

  /** Short, as the column may be narrow, where the arrow would be left out: the port there follows in the text. */
  @Override
  public String name() {
    return end.port().port() + (leads() ? " \u2192 " : " \u2190 ") + other().ruic();
  }

  @Override
  public String word() {
    return "bridge";
  }

  @Override
  public String text() {
    boolean carries = bridge.state() == BridgeStatus.State.CARRYING;
    return carries ? Figures.of(bridge.rateHz(), 1, "Hz") + ", lag " + Figures.of(bridge.lagSeconds() * MILLIS, 1, "ms")
        + ", " + other().port().port() : bridge.text();
  }

  @Override
  public String dropped() {
    return bridge.counts().dropped() == 0 ? "" : Long.toString(bridge.counts().dropped());
  }

  @Override
  public String details() {
    BridgeStatus.Counts counts = bridge.counts();
    return Stream.of("Bridge " + bridge.name() + ", " + bridge.state().name().toLowerCase(Locale.ROOT),
        bridge.from() + " \u2192 " + bridge.to(), text(),
        counts.received() + " received, " + counts.passed() + " passed, " + counts.thinned() + " thinned, "
            + counts.dropped() + " dropped, " + counts.refused() + " refused",
        bridge.holder().map(who -> who + " has control").orElse(""))
        .filter(line -> !line.isEmpty()).collect(Collectors.joining("\n"));
  }

  @Override
  public boolean isProblem() {
    return ConnectionLine.super.isProblem() || bridge.counts().dropped() > 0;
  }
}
