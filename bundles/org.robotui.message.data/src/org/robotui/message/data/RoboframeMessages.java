package org.robotui.message.data;

import java.util.List;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.message.data.DataMessages.Maker;
import org.robotui.message.roboframe.BatteryStreamable;
import org.robotui.message.roboframe.GridStreamable;
import org.robotui.message.roboframe.OdometryStreamable;
import org.robotui.message.roboframe.PictureStreamable;
import org.robotui.message.roboframe.PoseStreamable;
import org.robotui.message.roboframe.ScanStreamable;
import org.robotui.message.roboframe.TargetStreamable;
import org.robotui.message.roboframe.VelocityStreamable;

/** Data types as the types that robots of RoboFrame have in common: what is no part of a plane is left out. */
final class RoboframeMessages {
  private RoboframeMessages() {}

  static List<Maker<?, ?>> all() {
    return List.of(
        Maker.of(LaserScan.class, ScanStreamable.class, RoboframeMessages::scan),
        Maker.of(Odometry.class, OdometryStreamable.class, RoboframeMessages::odometry),
        Maker.of(StampedPose.class, PoseStreamable.class, RoboframeMessages::pose),
        Maker.of(Battery.class, BatteryStreamable.class,
            (b, at) -> new BatteryStreamable(at, b.voltage(), b.current(), b.charge(),
                b.status() == Battery.Status.CHARGING)),
        Maker.of(CompressedImage.class, PictureStreamable.class,
            (i, at) -> new PictureStreamable(at, i.frame().name(), i.format(), SensorMessages.bytes(i.data()))),
        Maker.of(GridMap.class, GridStreamable.class, RoboframeMessages::grid));
  }

  static VelocityStreamable velocity(VelocityCommand c) {
    return new VelocityStreamable(c.linear().x(), c.linear().y(), c.angular().z());
  }

  static TargetStreamable target(NavigationGoal g) {
    return new TargetStreamable(g.frame().name(), g.pose().translation().x(), g.pose().translation().y(),
        heading(g.pose()));
  }

  private static double heading(RigidTransform pose) {
    Quaternion q = pose.rotation();
    return Math.atan2(2 * (q.w() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()));
  }

  private static ScanStreamable scan(LaserScan s, long at) {
    float[] ranges = new float[s.ranges().size()];
    s.ranges().buffer().get(ranges);
    return new ScanStreamable(at, s.frame().name(), (float) s.angleMin(), (float) s.angleIncrement(),
        (float) s.rangeMin(), (float) s.rangeMax(), ranges);
  }

  private static OdometryStreamable odometry(Odometry o, long at) {
    return new OdometryStreamable(at, o.frame().name(), o.childFrame().name(), o.pose().translation().x(),
        o.pose().translation().y(), heading(o.pose()), o.linear().x(), o.linear().y(), o.angular().z());
  }

  private static PoseStreamable pose(StampedPose p, long at) {
    return new PoseStreamable(at, p.frame().name(), p.pose().translation().x(), p.pose().translation().y(),
        heading(p.pose()));
  }

  private static GridStreamable grid(GridMap m, long at) {
    return new GridStreamable(at, m.frame().name(), m.resolution(), m.width(), m.height(),
        m.origin().translation().x(), m.origin().translation().y(), SensorMessages.bytes(m.cells()));
  }
}
