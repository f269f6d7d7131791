package org.robotui.core.internal.life;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Match;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.link.LinkState;

/** Puts together how a RUIC is doing. */
final class Snapshots {
  private Snapshots() {}

  static RuicSnapshot of(String name, Health health, Components components, List<Match> matches, long now) {
    List<ComponentStatus> all = new ArrayList<>();
    components.rfics().forEach(s -> all.add(s.status()));
    components.shown().forEach(s -> all.add(s.status(health.state())));
    List<PortStatus> ports = components.rfics().stream().flatMap(s -> s.offers().stream())
        .map(o -> wanted(o.status(now), matches))
        .sorted(Comparator.comparing(PortStatus::kind).thenComparing(p -> p.port().toString())).toList();
    return new RuicSnapshot(
        name, health.state(), health.reason(), link(components), List.copyOf(all), ports, matches);
  }

  /** A port is wanted where something taps it or a view is connected. */
  private static PortStatus wanted(PortStatus p, List<Match> matches) {
    boolean connected = matches.stream().anyMatch(m -> m.kind() == p.kind() && m.peers().contains(p.port()));
    return connected == p.wanted() || p.wanted() ? p : new PortStatus(p.port(), p.kind(), p.typeName(), true, p.count(),
        p.rateHz(), p.ageSeconds(), p.stale(), p.dropped(), p.problem(), p.value());
  }

  private static LinkState link(Components components) {
    return components.rfics().stream().map(RficSlot::link).max(Comparator.comparingInt(Snapshots::badness))
        .orElseGet(LinkState.Disconnected::new);
  }

  private static int badness(LinkState link) {
    return switch (link) {
      case LinkState.Connected c -> 0;
      case LinkState.Degraded d -> 1;
      case LinkState.Connecting c -> 2;
      case LinkState.Disconnected d -> 3;
      case LinkState.Failed f -> 4;
    };
  }
}
