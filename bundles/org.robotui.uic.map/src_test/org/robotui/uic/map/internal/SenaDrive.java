package org.robotui.uic.map.internal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.robotui.data.array.Floats;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.message.Generation;
import org.robotui.message.MessageException;
import org.robotui.message.RecordBinding;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.testkit.recorded.BagReader;

/** Scans and poses of a recorded drive through a building, one scan for each pose. */
final class SenaDrive {
  record Entry(LaserScan scan, RigidTransform odomFromBase) {}

  private static final RecordBinding<Odometry> ODOMETRY = RecordBinding.shipped(Odometry.class, Generation.ROS1);
  private static final RecordBinding<org.robotui.message.ros.sensor_msgs.LaserScan> SCAN =
      RecordBinding.shipped(org.robotui.message.ros.sensor_msgs.LaserScan.class, Generation.ROS1);

  private SenaDrive() {}

  static List<Entry> read(Path bag) {
    List<RigidTransform> poses = new ArrayList<>();
    List<LaserScan> scans = new ArrayList<>();
    for (BagReader.Recorded each : BagReader.read(bag)) {
      try {
        switch (each.topic()) {
          case "/odom" -> poses.add(pose(ODOMETRY.decode(each.bytes()).pose().pose()));
          case "/scan" -> scans.add(scan(SCAN.decode(each.bytes())));
          default -> {
            // neither of both
          }
        }
      } catch (MessageException e) {
        throw new AssertionError(bag.toString(), e);
      }
    }
    List<Entry> entries = new ArrayList<>();
    for (int i = 0; i < Math.min(poses.size(), scans.size()); i++) {
      entries.add(new Entry(scans.get(i), poses.get(i)));
    }
    return entries;
  }

  private static RigidTransform pose(Pose pose) {
    return RigidTransform.planar(pose.position().x(), pose.position().y(),
        2 * Math.atan2(pose.orientation().z(), pose.orientation().w()));
  }

  private static LaserScan scan(org.robotui.message.ros.sensor_msgs.LaserScan scan) {
    return new LaserScan(DemoRoom.LASER, scan.angleMin(), scan.angleIncrement(), scan.rangeMin(), scan.rangeMax(), 0.2,
        Floats.wrap(scan.ranges()), Floats.EMPTY);
  }
}
