package org.robotui.bridge.internal.carry;

import java.util.Optional;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.bridge.internal.far.HeldParameter;

/** A parameter at two robot UIs that are there. */
final class ParameterRoute implements AutoCloseable {
  private final WayEnds ends;
  private final Ruic source;
  private final Ruic sink;
  private final PortAccess here;
  private final PortAccess beyond;
  private final HeldParameter near;
  private final HeldParameter far;

  private ParameterRoute(WayEnds ends, Ruic source, Ruic sink) {
    this.ends = ends;
    this.source = source;
    this.sink = sink;
    this.here = source.access(ends.principal());
    this.beyond = sink.access(ends.principal());
    this.near = new HeldParameter(ends.from(), source, here);
    this.far = new HeldParameter(ends.to(), sink, beyond);
  }

  static Optional<ParameterRoute> of(WayEnds ends, CarryContext surroundings) {
    return surroundings.ruic(ends.from()).flatMap(source -> surroundings.ruic(ends.to())
        .map(sink -> new ParameterRoute(ends, source, sink)));
  }

  boolean isCurrent(CarryContext now) {
    return ends.stillJoin(source, sink, now);
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
