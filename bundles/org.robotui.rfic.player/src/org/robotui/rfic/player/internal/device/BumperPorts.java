package org.robotui.rfic.player.internal.device;

import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.Bumpers;
import org.robotui.player.interfaces.Bumper;
import org.robotui.rfic.player.internal.convert.BumperParts;

/**
 * Bumpers: where they are, and which are pressed. A device that does not tell where they are still tells which are
 * pressed.
 */
final class BumperPorts {
  private final Outlet<Bumpers> outlet;
  private final FrameId base;
  private volatile Optional<List<Bumper.Part>> parts = Optional.empty();

  BumperPorts(DeviceFeed feed) {
    this.base = feed.around().tree().names().base();
    this.outlet = feed.outlet("", Bumpers.class, "its bumpers, and which are pressed");
    feed.onOpen(() -> feed.ask(Bumper.GET_GEOMETRY, g -> parts = Optional.of(g.bumpers()), this::untold));
    feed.on(Bumper.GEOMETRY, outlet, (m, r) -> parts = Optional.of(m.bumpers()));
    feed.on(Bumper.STATE, outlet,
        (m, r) -> parts.ifPresent(known -> outlet.publish(BumperParts.of(known, m.pressed(), base), r)));
  }

  private void untold(String reason) {
    if (parts.isEmpty()) {
      parts = Optional.of(List.of());
      outlet.lost(reason + "; where the bumpers are is not known");
    }
  }
}
