package org.robotui.rfic.player.internal.device;

import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.navigation.Odometry;
import org.robotui.player.interfaces.Body;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.interfaces.Position3d;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;
import org.robotui.rfic.player.internal.convert.FrameNames;
import org.robotui.rfic.player.internal.convert.Motions;

/** What drives. One device moves the base; others, such as what corrects its odometry, only say where they are. */
final class Bases {
  private static final String VELOCITY = "/velocity";

  private Bases() {}

  static void position2d(DeviceFeed feed) {
    Outlet<Odometry> outlet = feed.outlet("", Odometry.class, "where it is and how it moves");
    FrameId odom = names(feed).odom();
    FrameId child = child(feed);
    feed.on(Position2d.STATE, outlet, (m, r) -> moved(feed, outlet, Motions.odometry(m, odom, child), r));
    body(feed, Position2d.GET_GEOMETRY, Position2d.GEOMETRY);
    feed.command(VELOCITY, VelocityCommand.class, "velocity of the base",
        new Driving<>(feed, c -> feed.device().command(Position2d.VELOCITY, Motions.planar(c)),
            c -> feed.device().commandUnopened(Position2d.VELOCITY, Motions.planar(c)), VelocityCommand.ZERO,
            c -> Optional.empty()));
  }

  static void position3d(DeviceFeed feed) {
    Outlet<Odometry> outlet = feed.outlet("", Odometry.class, "where it is and how it moves");
    FrameId odom = names(feed).odom();
    FrameId child = child(feed);
    feed.on(Position3d.STATE, outlet, (m, r) -> moved(feed, outlet, Motions.odometry(m, odom, child), r));
    body(feed, Position3d.GET_GEOMETRY, Position3d.GEOMETRY);
    feed.command(VELOCITY, VelocityCommand.class, "velocity of the vehicle",
        new Driving<>(feed, c -> feed.device().command(Position3d.VELOCITY, Motions.spatial(c)),
            c -> feed.device().commandUnopened(Position3d.VELOCITY, Motions.spatial(c)), VelocityCommand.ZERO,
            c -> Optional.empty()));
  }

  private static void moved(DeviceFeed feed, Outlet<Odometry> outlet, Odometry odometry, Reception reception) {
    if (feed.around().isBase(feed.name())) {
      feed.around().tree().moved(odometry, reception.stamp(), feed.name());
    }
    outlet.publish(odometry, reception);
  }

  /** Only the base has an outline: views draw one robot. */
  private static void body(DeviceFeed feed, Kind.Request<Empty, Body> request, Kind.Data<Body> data) {
    if (!feed.around().isBase(feed.name())) {
      return;
    }
    FrameId base = names(feed).base();
    Outlet<Footprint> outlet = feed.outlet("/footprint", Footprint.class, "the outline of the robot");
    feed.onOpen(() -> feed.ask(request,
        b -> Motions.footprint(b, base).ifPresent(f -> outlet.publish(f, Reception.now())), outlet::failed));
    feed.on(data, outlet, (m, r) -> Motions.footprint(m, base).ifPresent(f -> outlet.publish(f, r)));
  }

  private static FrameNames names(DeviceFeed feed) {
    return feed.around().tree().names();
  }

  private static FrameId child(DeviceFeed feed) {
    return feed.around().isBase(feed.name()) ? names(feed).base() : names(feed).device(feed.name());
  }
}
