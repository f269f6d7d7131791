package org.robotui.rfic.player.internal.device;

import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.RigidTransform;
import org.robotui.player.interfaces.Ranger;
import org.robotui.rfic.player.internal.convert.Poses;
import org.robotui.rfic.player.internal.convert.Scans;
import org.robotui.rfic.player.internal.convert.Sonars;

/**
 * A ranger is a scanner or a ring of sensors; which one it is, it tells only when it is open. So both ports are offered
 * until then, and the one that does not fit is withdrawn.
 */
final class RangerPorts {
  private final DeviceFeed feed;
  private final Outlet<LaserScan> scan;
  private final Outlet<RangeReadings> readings;
  private final FrameId frame;
  private volatile Optional<Ranger.Geometry> geometry = Optional.empty();
  private volatile Optional<Ranger.Config> config = Optional.empty();
  private volatile boolean decided;

  RangerPorts(DeviceFeed feed) {
    this.feed = feed;
    this.scan = feed.outlet("/scan", LaserScan.class, "what it sees, where it is a scanner");
    this.readings = feed.outlet("/readings", RangeReadings.class, "what its sensors see, where it is a ring of them");
    this.frame = feed.around().tree().names().device(feed.name());
    feed.onOpen(this::ask);
    feed.on(Ranger.GEOMETRY, scan, (m, r) -> located(m));
    feed.on(Ranger.RANGES, scan, (m, r) -> measured(m.ranges(), r));
    feed.on(Ranger.STAMPED_RANGES, scan, (m, r) -> {
      if (m.hasConfig()) {
        config = Optional.of(m.config());
      }
      if (m.hasGeometry()) {
        located(m.geometry());
      }
      measured(m.data().ranges(), r);
    });
  }

  private void ask() {
    feed.ask(Ranger.GET_GEOMETRY, this::located, this::unknown);
    feed.ask(Ranger.GET_CONFIG, c -> config = Optional.of(c), this::unknown);
  }

  private void unknown(String reason) {
    scan.failed(reason);
    readings.failed(reason);
  }

  private void located(Ranger.Geometry told) {
    RigidTransform baseFromDevice = Poses.mounted(told.pose());
    feed.around().tree().mounted(frame, baseFromDevice, feed.name());
    RangeFinders.elements(feed, baseFromDevice, told.elementPoses());
    geometry = Optional.of(told);
  }

  private void measured(double[] ranges, Reception reception) {
    if (config.isEmpty() || geometry.isEmpty()) {
      return; // what it measures cannot be placed yet; what it does not tell is said at the ports
    }
    boolean ring = geometry.get().elementPoses().size() > 1 && geometry.get().elementPoses().size() == ranges.length;
    decide(ring);
    if (ring) {
      Sonars.Beam beam = feed.around().sonars().told(config.get());
      readings.publish(Sonars.of(ranges, beam, RangeReading.Kind.ULTRASOUND, feed.around().tree().names(), feed.name()),
          reception);
    } else {
      scan.publish(Scans.of(ranges, config.get(), frame), reception);
    }
  }

  private void decide(boolean ring) {
    if (!decided) {
      decided = true;
      feed.drop(ring ? scan : readings);
    }
  }
}
