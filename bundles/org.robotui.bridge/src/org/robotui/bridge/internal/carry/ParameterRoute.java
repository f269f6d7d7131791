package org.robotui.bridge.internal.carry;

import java.util.Optional;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.command.Principal;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.bridge.internal.far.HeldParameter;

/** A parameter at two robot UIs that are there. */
final class ParameterRoute implements AutoCloseable {
  private final BridgeEnd from;
  private final BridgeEnd to;
  private final Ruic source;
  private final Ruic sink;
  private final PortAccess here;
  private final PortAccess beyond;
  private final HeldParameter near;
  private final HeldParameter far;

  private ParameterRoute(BridgeEnd from, BridgeEnd to, Ruic source, Ruic sink, Principal principal) {
    this.from = from;
    this.to = to;
    this.source = source;
    this.sink = sink;
    this.here = source.access(principal);
    this.beyond = sink.access(principal);
    this.near = new HeldParameter(from, source, here);
    this.far = new HeldParameter(to, sink, beyond);
  }

  static Optional<ParameterRoute> of(BridgeEnd from, BridgeEnd to, Principal principal, CarryContext surroundings) {
    return surroundings.ruic(from).flatMap(source -> surroundings.ruic(to)
        .map(sink -> new ParameterRoute(from, to, source, sink, principal)));
  }

  boolean isCurrent(CarryContext now) {
    return now.ruic(from).filter(r -> r == source).isPresent() && now.ruic(to).filter(r -> r == sink).isPresent();
  }

  HeldParameter near() {
    return near;
  }

  HeldParameter far() {
    return far;
  }

  /** Why it cannot be looked at now. */
  Optional<String> missing() {
    return near.missing().or(far::missing);
  }

  @Override
  public void close() {
    far.close();
    here.close();
    beyond.close();
  }
}
