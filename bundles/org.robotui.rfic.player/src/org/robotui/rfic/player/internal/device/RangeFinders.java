package org.robotui.rfic.player.internal.device;

import java.util.ArrayList;
import java.util.List;
import org.robotui.data.FrameId;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.RigidTransform;
import org.robotui.player.interfaces.Body;
import org.robotui.player.interfaces.Laser;
import org.robotui.player.interfaces.Pose3d;
import org.robotui.player.interfaces.Sonar;
import org.robotui.rfic.player.internal.convert.Poses;
import org.robotui.rfic.player.internal.convert.Scans;
import org.robotui.rfic.player.internal.convert.Sonars;
import org.robotui.rfic.player.internal.link.Stamps;

/** Scanners and rings of sonars by their older interfaces. */
final class RangeFinders {
  private static final int MOST_SENSORS = 1024;

  private RangeFinders() {}

  static void laser(DeviceFeed feed) {
    Outlet<LaserScan> outlet = feed.outlet("", LaserScan.class, "what the scanner sees");
    FrameId frame = Mount.of(feed, Laser.GET_GEOMETRY, Body::pose);
    feed.on(Laser.SCAN, outlet, (m, r) -> outlet.publish(Scans.of(m, frame), r));
    feed.on(Laser.POSED_SCAN, outlet, (m, r) -> outlet.publish(Scans.of(m.scan(), frame), r));
  }

  static void sonar(DeviceFeed feed) {
    Outlet<RangeReadings> outlet = feed.outlet("", RangeReadings.class, "what the sonars see");
    feed.onOpen(
        () -> feed.ask(Sonar.GET_GEOMETRY, g -> elements(feed, RigidTransform.IDENTITY, g.poses()), outlet::failed));
    feed.on(Sonar.GEOMETRY, outlet, (m, r) -> elements(feed, RigidTransform.IDENTITY, m.poses()));
    feed.on(Sonar.RANGES, outlet, (m, r) -> outlet.publish(Sonars.of(Sonars.doubles(m.ranges()), feed.around().sonars(),
        RangeReading.Kind.ULTRASOUND, feed.around().tree().names(), feed.name()), r));
  }

  /** Says where the sensors of a ring are. */
  static void elements(DeviceFeed feed, RigidTransform baseFromDevice, List<Pose3d> poses) {
    if (poses.size() > MOST_SENSORS) {
      throw new IllegalArgumentException(
          poses.size() + " sensors are more than a ring of " + MOST_SENSORS + " can have");
    }
    FrameTree tree = feed.around().tree();
    List<FrameTransform> mounts = new ArrayList<>();
    for (int i = 0; i < poses.size(); i++) {
      mounts.add(new FrameTransform(tree.names().base(), tree.names().element(feed.name(), i), Stamps.wall(),
          baseFromDevice.times(Poses.mounted(poses.get(i))), true));
    }
    tree.mounted(mounts, feed.name());
  }
}
