package org.robotui.core.internal.life;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Match;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.time.NanoClock;

/** Puts together how a RUIC is doing. */
final class Snapshots {
  /**
   * By kind and name, without making a text of each: there may be thousands, which come sorted but where there are
   * several interfaces.
   */
  private static final Comparator<PortStatus> ORDER =
      Comparator.comparing(PortStatus::kind).thenComparing(p -> p.port().component())
          .thenComparing(p -> p.port().port());

  /** A port to which a view is connected. */
  private record Wired(PortKind kind, SourceId port) {}

  private Snapshots() {}

  static RuicSnapshot of(String name, Health health, Components components, List<Match> matches, NanoClock clock) {
    List<ComponentStatus> all = new ArrayList<>();
    components.rfics().forEach(s -> all.add(s.status()));
    components.shown().forEach(s -> all.add(s.status(health.state())));
    Set<Wired> wired = matches.stream()
        .flatMap(m -> m.peers().stream().map(p -> new Wired(m.kind(), p))).collect(Collectors.toSet());
    List<PortStatus> ports = components.rfics().stream().flatMap(s -> s.offers().stream())
        .map(o -> wanted(o.status(clock), wired)).sorted(ORDER).toList();
    return new RuicSnapshot(
        name, health.state(), health.reason(), link(components), List.copyOf(all), ports, matches);
  }

  /** A port is wanted where something taps it or a view is connected. */
  private static PortStatus wanted(PortStatus p, Set<Wired> wired) {
    boolean connected = !p.wanted() && wired.contains(new Wired(p.kind(), p.port()));
    return !connected ? p
        : new PortStatus(p.port(), p.kind(), p.typeName(), true, p.count(),
            p.rateHz(), p.ageSeconds(), p.stale(), p.dropped(), p.problem(), p.value(), p.delivery());
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
