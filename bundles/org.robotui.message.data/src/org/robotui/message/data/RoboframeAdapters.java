package org.robotui.message.data;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.roboframe.BatteryStreamable;
import org.robotui.message.roboframe.GridStreamable;
import org.robotui.message.roboframe.LogLineStreamable;
import org.robotui.message.roboframe.ModuleStateStreamable;
import org.robotui.message.roboframe.ModuleStatesStreamable;
import org.robotui.message.roboframe.OdometryStreamable;
import org.robotui.message.roboframe.PictureStreamable;
import org.robotui.message.roboframe.PoseStreamable;
import org.robotui.message.roboframe.ScanStreamable;
import org.robotui.message.roboframe.VelocityStreamable;

/** The types that robots of RoboFrame have in common. */
final class RoboframeAdapters {
  private RoboframeAdapters() {}

  static List<Adapter<?, ?>> all() {
    return List.of(
        Adapter.of(ScanStreamable.class, LaserScan.class,
            (m, names) -> new LaserScan(names.frame(m.frame()), m.start(), m.step(), m.nearest(), m.farthest(), 0,
                Floats.wrap(m.ranges()), Floats.EMPTY),
            ScanStreamable::stamp),
        Adapter.of(OdometryStreamable.class, Odometry.class, RoboframeAdapters::odometry, OdometryStreamable::stamp),
        Adapter.of(PoseStreamable.class, StampedPose.class,
            (m, names) -> new StampedPose(names.frame(m.frame()), pose(m.x(), m.y(), m.heading())),
            PoseStreamable::stamp),
        Adapter.of(VelocityStreamable.class, VelocityCommand.class,
            (m, names) -> new VelocityCommand(new Vector3(m.forward(), m.left(), 0), new Vector3(0, 0, m.turn())),
            m -> 0),
        Adapter.of(BatteryStreamable.class, Battery.class,
            (m, names) -> new Battery(m.voltage(), m.current(), m.charge(),
                m.charging() ? Battery.Status.CHARGING : Battery.Status.DISCHARGING),
            BatteryStreamable::stamp),
        Adapter.of(PictureStreamable.class, CompressedImage.class,
            (m, names) -> new CompressedImage(names.frame(m.frame()), m.format(), Bytes.wrap(m.data())),
            PictureStreamable::stamp),
        Adapter.of(GridStreamable.class, GridMap.class, RoboframeAdapters::grid, GridStreamable::stamp),
        Adapter.of(LogLineStreamable.class, LogEntry.class,
            (m, names) -> new LogEntry(severity(m.level()), m.module(), m.text(), ""), LogLineStreamable::stamp),
        Adapter.of(ModuleStatesStreamable.class, Diagnostics.class,
            (m, names) -> new Diagnostics(m.modules().stream().map(RoboframeAdapters::item).toList()),
            ModuleStatesStreamable::stamp));
  }

  private static RigidTransform pose(double x, double y, double heading) {
    return new RigidTransform(new Vector3(x, y, 0), Quaternion.fromYaw(heading));
  }

  private static Odometry odometry(OdometryStreamable m, FrameNames names) {
    FrameId frame = names.frame(m.frame());
    return new Odometry(frame, names.frame(m.body()), pose(m.x(), m.y(), m.heading()), Doubles.EMPTY,
        new Vector3(m.forward(), m.left(), 0), new Vector3(0, 0, m.turn()), Doubles.EMPTY);
  }

  private static GridMap grid(GridStreamable m, FrameNames names) {
    return new GridMap(names.frame(m.frame()), m.resolution(), Sizes.of("width", m.width()),
        Sizes.of("height", m.height()), pose(m.x(), m.y(), 0), Bytes.wrap(m.cells()));
  }

  private static Severity severity(int level) {
    Severity[] all = Severity.values();
    return level >= 0 && level < all.length ? all[level] : Severity.ERROR;
  }

  private static Diagnostics.Item item(ModuleStateStreamable m) {
    Map<String, String> values = new LinkedHashMap<>();
    values.put("runs", Long.toString(m.runs()));
    return new Diagnostics.Item(m.name(), "", m.failed() ? Diagnostics.Level.ERROR : Diagnostics.Level.OK, m.text(),
        values);
  }
}
