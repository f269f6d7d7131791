package org.robotui.sim.internal.smartsoft;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.LongSupplier;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.sensor.LaserSpec;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.Pose2;

/** Makes what the robot says, in millimetres. */
final class SmartObjects {
  static final int NOT_PRESSED = 1;
  static final int PRESSED = 2;

  private static final double PER_METRE = 1000;
  private static final double PERCENT = 100;
  private static final double HUNDREDTHS = 100;
  private static final double FULL_TURN = 36_000;
  private static final long NANOS = 1_000_000_000;
  private static final long MICRO = 1000;
  private static final int UNKNOWN = 205;
  private static final int OCCUPIED = 127;
  private static final int PARTICLES = 100;
  private static final long SEED = 7;
  private static final double SPREAD = 0.05;
  private static final double LOST = 1;

  private final SimulatedRobot robot;
  private final LongSupplier clock;

  SmartObjects(SimulatedRobot robot, LongSupplier clock) {
    this.robot = robot;
    this.clock = clock;
  }

  private Map<String, Object> time() {
    long now = clock.getAsLong();
    return Map.of("sec", now / NANOS, "usec", now % NANOS / MICRO);
  }

  private static Map<String, Object> pose(Pose2 pose) {
    return Map.of("position", Map.of("x", pose.x() * PER_METRE, "y", pose.y() * PER_METRE), "orientation",
        Map.of("azimuth", pose.yaw()));
  }

  private Map<String, Object> place(Pose2 pose, double spread) {
    double square = spread * PER_METRE * spread * PER_METRE;
    return Map.of("covInvalid", false, "covMatrix", new double[]{square, 0, 0, 0, square, 0, 0, 0, spread * spread},
        "pose3D", pose(pose), "timeStamp", time());
  }

  Map<String, Object> base(RobotState state) {
    Map<String, Object> speed = Map.of("vX", state.speed().linear() * PER_METRE, "wZ", state.speed().angular(),
        "timeStamp", time());
    RobotState.BatteryReading battery = state.battery();
    int bumper = robot.model().bumpers().isEmpty() ? 0 : state.bumped() ? PRESSED : NOT_PRESSED;
    return Map.of("timeStamp", time(), "basePose", place(state.estimate(), state.lost() ? LOST : SPREAD),
        "baseOdomPose", place(state.odometry(), 0), "baseVelocity", speed, "baseOdomVelocity", speed, "batteryState",
        Map.of("potential", battery.voltage(), "current", battery.current(), "chargeLevel",
            (int) Math.round(battery.level() * PERCENT), "externalPower", battery.charging(), "timeStamp", time()),
        "baseBumperState", Map.of("bumperState", bumper));
  }

  /** Only rays that hit something are sent. */
  Map<String, Object> laser(RobotState state, float[] ranges) {
    LaserSpec spec = robot.model().laser();
    List<Map<String, Object>> points = new ArrayList<>();
    for (int i = 0; i < ranges.length; i++) {
      if (ranges[i] >= spec.rangeMin() && ranges[i] < spec.rangeMax()) {
        points.add(Map.of("index", i, "distance", Math.round(ranges[i] * PER_METRE)));
      }
    }
    Pose2 mount = new Pose2(spec.forward(), 0, 0);
    Map<String, Object> scan = Map.of("is_valid", true, "time", time(), "start_angle",
        (Math.toDegrees(spec.angleMin()) * HUNDREDTHS + FULL_TURN) % FULL_TURN, "resolution",
        Math.toDegrees(spec.increment()) * HUNDREDTHS, "distance_min", Math.round(spec.rangeMin() * PER_METRE),
        "distance_max", Math.round(spec.rangeMax() * PER_METRE), "length_unit", 1, "max_scan_points", ranges.length,
        "scan_points", points);
    return Map.of("base_state", base(state), "laser_scan_pose", Map.of("laser_scan", scan, "sensor_pose", pose(mount)),
        "laser_world_pose", pose(state.estimate().times(mount)));
  }

  Map<String, Object> map() {
    GridMap map = robot.map();
    byte[] cells = new byte[map.width() * map.height()];
    for (int y = 0; y < map.height(); y++) {
      for (int x = 0; x < map.width(); x++) {
        byte cell = map.at(x, y);
        cells[y * map.width() + x] =
            (byte) (cell == GridMap.UNKNOWN ? UNKNOWN : Math.round(cell * OCCUPIED / PERCENT));
      }
    }
    int cell = (int) Math.round(map.resolution() * PER_METRE);
    return Map.ofEntries(Map.entry("id", 1), Map.entry("is_valid", true), Map.entry("time", time()),
        Map.entry("xOffsetMM", Math.round(map.originX() * PER_METRE)),
        Map.entry("yOffsetMM", Math.round(map.originY() * PER_METRE)), Map.entry("cellSizeMM", cell),
        Map.entry("xOffsetCells", Math.round(map.originX() / map.resolution())),
        Map.entry("yOffsetCells", Math.round(map.originY() / map.resolution())),
        Map.entry("xSizeMM", map.width() * cell), Map.entry("ySizeMM", map.height() * cell),
        Map.entry("xSizeCells", map.width()), Map.entry("ySizeCells", map.height()),
        Map.entry("size", cells.length), Map.entry("cell", cells));
  }

  Map<String, Object> particles(RobotState state) {
    double spread = state.lost() ? LOST : SPREAD;
    Random random = new Random(SEED);
    List<Map<String, Object>> all = new ArrayList<>();
    for (int i = 0; i < PARTICLES; i++) {
      Pose2 off = new Pose2(spread * random.nextGaussian(), spread * random.nextGaussian(),
          spread * random.nextGaussian());
      all.add(Map.of("pose", pose(state.estimate().times(off)), "weight", 1.0 / PARTICLES));
    }
    return Map.of("particles", all);
  }

  /** The next point of the way, and the goal. */
  Map<String, Object> goal(RobotState state) {
    Pose2 goal = state.goal().orElseThrow();
    Pose2 next = state.path().isEmpty() ? goal : state.path().getFirst();
    return Map.of("id", 1, "xWayPoint", next.x() * PER_METRE, "yWayPoint", next.y() * PER_METRE, "xGoalPoint",
        goal.x() * PER_METRE, "yGoalPoint", goal.y() * PER_METRE);
  }
}
