package org.robotui.bridge.internal.carry;

import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.bridge.BridgeTransform.Direction;
import org.robotui.api.command.Principal;
import org.robotui.api.host.Ruic;

/**
 * Between what one way of a bridge carries, and in whose name.
 *
 * @param from where it takes
 * @param to where it gives
 * @param principal who commands there
 */
record WayEnds(BridgeEnd from, BridgeEnd to, Principal principal) {
  static WayEnds of(BridgeConfig config, Direction direction) {
    Principal principal = principal(config, ":" + direction);
    return direction == Direction.FORTH ? new WayEnds(config.from(), config.to(), principal)
        : new WayEnds(config.to(), config.from(), principal);
  }

  /** Of a bridge that has one way only. */
  static WayEnds of(BridgeConfig config) {
    return new WayEnds(config.from(), config.to(), principal(config, ""));
  }

  /** False where one of the robot UIs has gone, or another one has taken its place. */
  boolean stillJoin(Ruic source, Ruic sink, CarryContext now) {
    return now.ruic(from).filter(r -> r == source).isPresent() && now.ruic(to).filter(r -> r == sink).isPresent();
  }

  private static Principal principal(BridgeConfig config, String way) {
    return new Principal("bridge:" + config.file() + ":" + config.name() + way, "Bridge " + config.name(),
        Principal.Kind.SCRIPT);
  }
}
