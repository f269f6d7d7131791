package org.robotui.rfic.player.internal.device;

import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.MarkerSet;
import org.robotui.player.interfaces.Bumper;
import org.robotui.rfic.player.internal.convert.Bumpers;

/** Bumpers: which are pressed as a record, for plots and alerts, and as lines around the robot, for scenes. */
final class BumperPorts {
  private final DeviceFeed feed;
  private final Outlet<MarkerSet> outlet;
  private final FrameId base;
  private volatile Optional<Bumper.Geometry> geometry = Optional.empty();

  BumperPorts(DeviceFeed feed) {
    this.feed = feed;
    this.base = feed.around().tree().names().base();
    feed.records("", feed.around().layouts().byName("bumper").flatMap(b -> b.message(Bumper.STATE.wireType(), Bumper.STATE.message())));
    this.outlet = feed.outlet("/markers", MarkerSet.class, "where its bumpers are, red where they are pressed");
    feed.onOpen(() -> feed.ask(Bumper.GET_GEOMETRY, g -> geometry = Optional.of(g), outlet::failed));
    feed.on(Bumper.GEOMETRY, outlet, (m, r) -> geometry = Optional.of(m));
    feed.on(Bumper.STATE, outlet, this::told);
  }

  private void told(Bumper.State m, Reception reception) {
    geometry.ifPresent(g -> outlet.publish(
        Bumpers.of(g, m.pressed(), base, feed.name(), reception.stamp(), reception.nanos()), reception));
  }
}
