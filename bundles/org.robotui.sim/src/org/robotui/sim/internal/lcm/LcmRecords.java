package org.robotui.sim.internal.lcm;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.robotui.lcm.type.LcmRecord;
import org.robotui.sim.internal.Event;
import org.robotui.sim.internal.GoalStatus;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.RobotState.BatteryReading;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.model.RobotModel;
import org.robotui.sim.internal.robot.Battery;
import org.robotui.sim.internal.robot.Head;
import org.robotui.sim.internal.sensor.BumperSpec;
import org.robotui.sim.internal.sensor.Imu;
import org.robotui.sim.internal.sensor.LaserSpec;
import org.robotui.sim.internal.sensor.SonarSpec;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.Pose2;

/** Makes the records that the robot sends. */
final class LcmRecords {
  static final String MAP = "map";
  static final String ODOMETRY = "odom";
  static final String BASE = "base";
  private static final double SECONDS_AN_HOUR = 3600;

  private final Types types;
  private final RobotModel robot;

  LcmRecords(Types types, SimulatedRobot robot) {
    this.types = types;
    this.robot = robot.model();
  }

  LcmRecord pose(RobotState state, long utime) {
    return types.pose(utime, MAP, state.estimate());
  }

  LcmRecord odometry(RobotState state, long utime) {
    Pose2 at = state.odometry();
    return types.make("odometry_t", utime).text("frame", ODOMETRY).text("child_frame", BASE)
        .numbers("position", at.x(), at.y(), 0).numbers("orientation", Types.turned(at.yaw()))
        .numbers("linear_velocity", state.speed().linear(), 0, 0)
        .numbers("angular_velocity", 0, 0, state.speed().angular()).build();
  }

  LcmRecord transforms(RobotState state, long utime) {
    List<LcmRecord> all = new ArrayList<>();
    all.add(types.transform(utime, MAP, ODOMETRY, state.mapFromOdometry(), 0));
    all.add(types.transform(utime, ODOMETRY, BASE, state.odometry(), 0));
    all.add(types.transform(utime, BASE, "laser", new Pose2(robot.laser().forward(), 0, 0), robot.laser().height()));
    all.add(camera(utime));
    state.head().ifPresent(head -> all.add(head(head, utime)));
    return types.make("transforms_t", utime).records("transforms", all).build();
  }

  /** Looks along its z axis, with x to the right. */
  private LcmRecord camera(long utime) {
    return types.make("transform_t", utime).text("parent", BASE).text("child", "camera")
        .numbers("position", robot.lens().forward(), 0, robot.lens().above())
        .numbers("orientation", 0.5, -0.5, 0.5, -0.5).build();
  }

  private LcmRecord head(Head head, long utime) {
    double pan = head.pan() / 2;
    double tilt = head.tilt() / 2;
    return types.make("transform_t", utime).text("parent", BASE).text("child", "head")
        .numbers("position", 0, 0, Head.HEIGHT + Head.NECK)
        .numbers("orientation", Math.cos(pan) * Math.cos(tilt), -Math.sin(pan) * Math.sin(tilt),
            Math.cos(pan) * Math.sin(tilt),
            Math.sin(pan) * Math.cos(tilt))
        .build();
  }

  LcmRecord laser(float[] ranges, long utime) {
    LaserSpec spec = robot.laser();
    return types.make("laser_t", utime).text("frame", "laser").real("angle_min", spec.angleMin())
        .real("angle_increment", spec.increment())
        .real("range_min", spec.rangeMin()).real("range_max", spec.rangeMax()).real("scan_time", 1 / spec.frequency())
        .numbers("ranges", doubles(ranges)).numbers("intensities").build();
  }

  private static double[] doubles(float[] values) {
    double[] all = new double[values.length];
    for (int i = 0; i < all.length; i++) {
      all[i] = values[i];
    }
    return all;
  }

  LcmRecord sonar(double[] ranges, long utime) {
    SonarSpec spec = robot.sonars();
    double[] heights = new double[ranges.length];
    Arrays.fill(heights, spec.height());
    return types.make("ranges_t", utime).text("frame", BASE).real("field_of_view", spec.cone())
        .real("range_min", spec.rangeMin()).real("range_max", spec.rangeMax()).numbers("ranges", ranges)
        .numbers("x", spec.mounts().stream().mapToDouble(Pose2::x).toArray())
        .numbers("y", spec.mounts().stream().mapToDouble(Pose2::y).toArray())
        .numbers("z", heights).numbers("yaw", spec.mounts().stream().mapToDouble(Pose2::yaw).toArray()).build();
  }

  LcmRecord bumper(RobotState state, long utime) {
    return types.make("bumper_t", utime).texts("names", robot.bumpers().stream().map(BumperSpec::name).toList())
        .numbers("pressed", state.bumpers().stream().mapToDouble(pressed -> pressed ? 1 : 0).toArray()).build();
  }

  LcmRecord imu(Imu imu, long utime) {
    return types.make("imu_t", utime).text("frame", BASE).numbers("orientation", Types.turned(imu.heading()))
        .numbers("angular_velocity", 0, 0, imu.turnRate())
        .numbers("acceleration", imu.forward(), imu.sideways(), Imu.GRAVITY).build();
  }

  LcmRecord battery(RobotState state, long utime) {
    BatteryReading battery = state.battery();
    return types.make("battery_t", utime).real("level", battery.level()).real("voltage", battery.voltage())
        .real("current", battery.current())
        .real("charge", battery.charge() * SECONDS_AN_HOUR).real("capacity", Battery.CAPACITY * SECONDS_AN_HOUR)
        .flag("charging", battery.charging()).build();
  }

  LcmRecord picture(byte[] jpeg, long utime) {
    return types.make("image_t", utime).text("frame", "camera").whole("width", robot.lens().width())
        .whole("height", robot.lens().height())
        .text("encoding", "jpeg").bytes("data", ByteBuffer.wrap(jpeg)).build();
  }

  LcmRecord map(GridMap map, long utime) {
    return types.make("map_t", utime).text("frame", MAP).real("resolution", map.resolution())
        .numbers("origin", map.originX(), map.originY(), 0)
        .whole("width", map.width()).whole("height", map.height()).bytes("cells", ByteBuffer.wrap(map.cells())).build();
  }

  LcmRecord path(RobotState state, long utime) {
    return types.make("path_t", utime).text("frame", MAP)
        .records("poses", state.path().stream().map(pose -> types.pose(utime, MAP, pose)).toList()).build();
  }

  LcmRecord goalStatus(GoalStatus status, long utime) {
    String name = status.number() == 0 ? "NONE" : switch (status.phase()) {
      case ACTIVE -> "ACTIVE";
      case SUCCEEDED -> "REACHED";
      case PREEMPTED -> "CANCELLED";
      case ABORTED -> "FAILED";
      case REJECTED -> "REFUSED";
    };
    return types.make("goal_status_t", utime).text("id", status.id())
        .whole("status", types.constant("goal_status_t", name))
        .text("text", status.text()).build();
  }

  LcmRecord log(Event event, long utime) {
    return types.make("log_t", utime).whole("level", types.constant("log_t", event.severity().name()))
        .text("source", event.source())
        .text("text", event.text()).build();
  }
}
