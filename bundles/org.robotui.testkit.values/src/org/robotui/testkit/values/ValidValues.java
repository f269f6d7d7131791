package org.robotui.testkit.values;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.MessageCommand;
import org.robotui.data.command.RelayMessage;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.Drives;
import org.robotui.data.control.Histogram;
import org.robotui.data.control.LoopTiming;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.geometry.Wrench;
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.data.joint.DisplayedTrajectory;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointMode;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.JointTrajectory;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.marker.Color;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.InteractiveMarker.Control;
import org.robotui.data.marker.InteractiveMarker.MenuEntry;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.data.marker.Marker;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.data.marker.MarkerSet;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.Bumper;
import org.robotui.data.sensor.Bumpers;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.display.FakePlaces;

/**
 * Data as they should be: one of each type, and one of each type of marker. All are of the robot and the frames of
 * {@link FakePlaces}.
 */
public final class ValidValues {
  private static final FrameId MAP = FakePlaces.frame("map");
  private static final RigidTransform POSE = new RigidTransform(new Vector3(1, 2, 0.5), Quaternion.fromYaw(0.7));
  private static final Doubles COVARIANCE = Doubles.wrap(new double[Odometry.COVARIANCE_SIZE]);
  private static final String URDF = """
      <robot name="arm"><link name="base"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
        <link name="hand"><visual><geometry><sphere radius="0.2"/></geometry></visual></link>
        <joint name="lift" type="prismatic"><parent link="base"/><child link="hand"/><axis xyz="0 0 1"/><limit lower="0" upper="1"/></joint></robot>
      """;

  private static final String ONE_PIXEL =
      "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==";

  private ValidValues() {}

  /**
   * One of each type.
   *
   * @return the values
   */
  public static List<Data> all() {
    List<Data> all = new ArrayList<>(List.<Data>of(cloud(), markers(), interactive(),
        new LaserScan(MAP, -1, 0.5, 0.1, 10, 0.1, Floats.of(1, 2, 3, 4, 5), Floats.of(9, 8, 7, 6, 5)),
        new GridMap(MAP, 0.05, 8, 4, POSE, Bytes.of(new byte[32])),
        new Odometry(MAP, MAP, POSE, COVARIANCE, new Vector3(1, 0, 0), Vector3.ZERO, COVARIANCE),
        new PoseEstimate(MAP, POSE, COVARIANCE), new StampedPose(MAP, POSE), new NavigationGoal(MAP, POSE),
        new Path(MAP, List.of(POSE, RigidTransform.IDENTITY, POSE)),
        new PoseArray(MAP, List.of(POSE, RigidTransform.IDENTITY)),
        new RangeReadings(List.of(new RangeReading(MAP, RangeReading.Kind.ULTRASOUND, 0.5, 0.1, 4, 2))),
        new Bumpers(MAP, List.of(new Bumper(POSE, 0.3, 0.2, true), new Bumper(RigidTransform.IDENTITY, 0.3, 0, false))),
        new Wrench(MAP, new Vector3(1, 2, 3), new Vector3(0, 0, 1)),
        new RawImage(MAP, 8, 6, PixelEncoding.RGB8, false, 24, Bytes.of(new byte[144])),
        new CameraInfo(MAP, 8, 6, "plumb_bob", Doubles.EMPTY, Doubles.of(8, 0, 4, 0, 8, 3, 0, 0, 1),
            Doubles.of(1, 0, 0, 0, 1, 0, 0, 0, 1),
            Doubles.of(8, 0, 4, 0, 0, 8, 3, 0, 0, 0, 1, 0))));
    all.addAll(states());
    all.addAll(List.<Data>of(new RobotDescription(FakePlaces.ROBOT, "robot_description", URDF, "", List.of()),
        new JointState(List.of(new JointState.Joint("lift", 0.5, 0, 0))), trajectory(),
        new DisplayedTrajectory("arm", List.of(new JointState.Joint("lift", 0.1, 0, 0)), List.of(trajectory()))));
    return all;
  }

  private static List<Data> states() {
    Histogram busy = new Histogram(List.of(1L, 5L, 2L), List.of(0L, 1000L, 2000L), 2500);
    LoopTiming.Loop loop = new LoopTiming.Loop("loop", "HAL", new LoopTiming.Schedule(1_000_000, 80, 1),
        new LoopTiming.Counts(9, 1, 1, 0, 0), busy, busy);
    return List.of(new Battery(24.1, -1.5, 0.7, Battery.Status.DISCHARGING),
        new Diagnostics(List.of(new Diagnostics.Item("base/motor", "m1", Diagnostics.Level.WARNING, "warm",
            Map.of("temperature", "61.5")))),
        new LogEntry(Severity.WARNING, "/base", "wheel slips", "base.cpp:12"),
        new Imu(MAP, Optional.of(Quaternion.IDENTITY), Optional.of(Vector3.ZERO), Optional.of(new Vector3(0, 0, 9.81))),
        new GpsFix(MAP, GpsFix.Quality.FIX, 0.85, 0.2, 400, 1.5),
        new Footprint(MAP,
            List.of(new Vector3(0.3, 0.2, 0), new Vector3(-0.3, 0.2, 0), new Vector3(-0.3, -0.2, 0),
                new Vector3(0.3, -0.2, 0))),
        new TransformSet(
            List.of(new FrameTransform(MAP, FakePlaces.frame("base"), new Stamp(1, ClockKind.ROBOT), POSE, false))),
        new VelocityCommand(new Vector3(0.5, 0, 0), new Vector3(0, 0, 0.2)),
        new CompressedImage(MAP, "png", Bytes.of(Base64.getDecoder().decode(ONE_PIXEL))),
        new JointModel(List.of(new JointModel.Joint("lift", 1, JointModel.Type.PRISMATIC, 0, 1, 0.5, 100)),
            List.of(new JointModel.Chain("arm", List.of("lift")))),
        new JointControl(List.of(new JointControl.Joint("lift", new JointControl.Measured(0.5, 0.5, 0, 0, 3, 40, 41),
            new JointControl.Reference(0.6, 0, 0, 100, 10), Set.of(JointMode.POSITION), JointControl.Source.COMMANDED,
            "plugin", 0, 0, 0))),
        new JointCommand(List.of(new JointCommand.Joint("lift", new JointControl.Reference(0.6, 0, 0, 100, 10),
            Set.of(JointMode.POSITION)))),
        new LoopTiming(true, List.of(loop)),
        new Drives(List.of(new Drives.Drive("lift", Drives.Phase.FAULT, "over-voltage"))),
        new ControlPlugins(List.of(new ControlPlugins.Plugin("walk", "libwalk.so", "host", "main",
            ControlPlugins.State.RUNNING, "well", "", 0, 1_000_000, 9, busy))),
        new MarkerFeedback("/feedback", "client", "goal", "move", MarkerFeedback.Event.POSE_UPDATE, MAP,
            Optional.empty(), POSE, 0, Optional.empty()),
        new MessageCommand("/talk", "std_msgs/String", Map.of("data", "hello")),
        new RelayMessage("/pose", "", new StampedPose(MAP, POSE), Optional.empty(), RelayMessage.Original.NONE, false,
            true, RelayMessage.Answer.NOBODY),
        new MapRecord("demo/State",
            Map.of("x", new FieldValue.Num(1.5, "1.5"), "on", new FieldValue.Flag(true), "name",
                new FieldValue.Text("a"),
                "at", new FieldValue.Time(5), "many", new FieldValue.Numbers(Doubles.of(1, 2, 3)),
                "parts", new FieldValue.Items(List.of(new FieldValue.Num(1, "1"))))));
  }

  private static JointTrajectory trajectory() {
    return new JointTrajectory(List.of("lift"), List.of(point(0, 0), point(1, 0.5), point(2, 1)));
  }

  private static JointTrajectory.Point point(double seconds, double position) {
    return new JointTrajectory.Point(seconds, Doubles.of(position), Doubles.EMPTY, Doubles.EMPTY, Doubles.EMPTY);
  }

  private static PointCloud cloud() {
    ByteBuffer points = ByteBuffer.allocate(20 * 24).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < 24; i++) {
      points.putFloat(i).putFloat(i % 5).putFloat(i % 3).putFloat(i).putInt(i * 10_000);
    }
    List<PointField> fields =
        List.of(field("x", 0), field("y", 4), field("z", 8), field("intensity", 12), field("rgb", 16));
    return new PointCloud(MAP, 6, 4, fields, 20, 120, ByteOrder.LITTLE_ENDIAN, true,
        Bytes.wrap(points.array(), 0, 480));
  }

  private static PointField field(String name, int offset) {
    return new PointField(name, offset, PointField.Format.FLOAT32, 1);
  }

  private static MarkerSet markers() {
    List<MarkerSet.Entry> entries = new ArrayList<>();
    for (Marker.Type type : Marker.Type.values()) {
      Marker made = marker(type);
      entries.add(new MarkerSet.Entry(made.key(), Optional.of(made)));
    }
    entries.add(new MarkerSet.Entry(new Marker.Key("gone", 1), Optional.empty()));
    return new MarkerSet(false, entries);
  }

  private static Marker marker(Marker.Type type) {
    return new Marker(new Marker.Key("things", type.ordinal()), MAP, Optional.empty(), 0, type, POSE,
        new Vector3(0.5, 0.5, 0.5), new Color(1, 0, 0, 1), 0, true,
        Floats.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1), Bytes.of(new byte[24]), "words",
        "package://none/a.stl", true);
  }

  private static InteractiveMarkerSet interactive() {
    List<Control> controls = new ArrayList<>();
    for (InteractiveMarker.Mode mode : InteractiveMarker.Mode.values()) {
      controls.add(new Control(mode.name(), "", mode, InteractiveMarker.Orientation.INHERIT, Quaternion.IDENTITY, true,
          List.of(marker(Marker.Type.CUBE)), false));
    }
    List<MenuEntry> menu =
        List.of(new MenuEntry(1, 0, "Go"), new MenuEntry(2, 1, "There"), new MenuEntry(3, 3, "Round and round"));
    InteractiveMarker marker =
        new InteractiveMarker("goal", "a goal", "", MAP, Optional.empty(), POSE, 1, menu, controls);
    return new InteractiveMarkerSet(false, List.of(new InteractiveMarkerSet.Entry("goal", Optional.of(marker))));
  }
}
