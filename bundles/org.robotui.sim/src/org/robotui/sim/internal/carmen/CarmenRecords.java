package org.robotui.sim.internal.carmen;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleSupplier;
import org.robotui.carmen.message.FieldName;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcValue;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.message.IpcRecordMaker;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.ZlibBytes;
import org.robotui.sim.internal.sensor.BumperSpec;
import org.robotui.sim.internal.sensor.Imu;
import org.robotui.sim.internal.sensor.LaserSpec;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.Pose2;

/** Makes what the robot says. Maps of CARMEN begin at 0, 0: places on the map are told from the map's corner. */
final class CarmenRecords {
  private static final int SICK = 3;
  private static final double ACCURACY = 0.01;
  private static final int PARTICLES = 100;
  private static final long SEED = 7;
  private static final double SPREAD = 0.05;
  private static final double LOST = 1;
  private static final float CERTAIN = 100;

  private final IpcForms forms;
  private final SimulatedRobot robot;
  private final DoubleSupplier clock;

  CarmenRecords(IpcForms forms, SimulatedRobot robot, DoubleSupplier clock) {
    this.forms = forms;
    this.robot = robot;
    this.clock = clock;
  }

  /** What it says by itself. */
  List<String> names() {
    List<String> names = new ArrayList<>(List.of("carmen_base_odometry", "carmen_simulator_truepos",
        "carmen_imu_message", "carmen_heartbeat", "carmen_localize_globalpos", "carmen_localize_particle",
        "carmen_navigator_status", "carmen_navigator_plan", "carmen_laser_laser1", "carmen_robot_frontlaser",
        "carmen_grid_map_message"));
    if (robot.model().sonars().count() > 0) {
      names.add("carmen_base_sonar");
    }
    if (!robot.model().bumpers().isEmpty()) {
      names.add("carmen_base_bumper");
    }
    return names;
  }

  private IpcRecordMaker make(String message) {
    return forms.get(message).make().number("timestamp", clock.getAsDouble()).text("host", CarmenFace.HOST);
  }

  Pose2 fromMap(double x, double y, double theta) {
    return new Pose2(x + robot.map().originX(), y + robot.map().originY(), theta);
  }

  private double[] onMap(Pose2 pose) {
    return new double[]{pose.x() - robot.map().originX(), pose.y() - robot.map().originY(), pose.yaw()};
  }

  private static double[] numbers(Pose2 pose) {
    return new double[]{pose.x(), pose.y(), pose.yaw()};
  }

  IpcRecordMaker odometry(RobotState state) {
    Pose2 at = state.odometry();
    return make("carmen_base_odometry").number("x", at.x()).number("y", at.y()).number("theta", at.yaw())
        .number("tv", state.speed().linear()).number("rv", state.speed().angular()).number("acceleration", 0.5);
  }

  IpcRecordMaker truth(RobotState state) {
    return make("carmen_simulator_truepos").struct("truepose", onMap(state.truth()))
        .struct("odometrypose", numbers(state.odometry()));
  }

  IpcRecordMaker imu() {
    Imu imu = robot.simulation().imu();
    return make("carmen_imu_message").number("acc_x", imu.forward()).number("acc_y", imu.sideways())
        .number("acc_z", Imu.GRAVITY).number("q0", Math.cos(imu.heading() / 2))
        .number("q3", Math.sin(imu.heading() / 2))
        .number("gyro_z", imu.turnRate());
  }

  IpcRecordMaker heartbeat() {
    return forms.get("carmen_heartbeat").make().text("module_name", "simulator")
        .number("pid", ProcessHandle.current().pid()).number("timestamp", clock.getAsDouble())
        .text("hostname", CarmenFace.HOST);
  }

  IpcRecordMaker place(RobotState state) {
    double spread = state.lost() ? LOST : SPREAD;
    return make("carmen_localize_globalpos").struct("globalpos", onMap(state.estimate()))
        .struct("globalpos_std", spread, spread, spread).struct("odometrypos", numbers(state.odometry()))
        .number("globalpos_xy_cov", Double.NaN).number("converged", state.lost() ? 0 : 1);
  }

  IpcRecordMaker particles(RobotState state) {
    double spread = state.lost() ? LOST : SPREAD;
    Random random = new Random(SEED);
    List<double[]> all = new ArrayList<>();
    for (int i = 0; i < PARTICLES; i++) {
      Pose2 off = new Pose2(spread * random.nextGaussian(), spread * random.nextGaussian(),
          spread * random.nextGaussian());
      double[] at = onMap(state.estimate().times(off));
      all.add(new double[]{at[0], at[1], at[2], 1.0 / PARTICLES});
    }
    return make("carmen_localize_particle").structs("particles", all)
        .struct("globalpos", onMap(state.estimate())).struct("globalpos_std", spread, spread, spread)
        .number("globalpos_xy_cov", Double.NaN);
  }

  IpcRecordMaker status(RobotState state) {
    double[] here = onMap(state.estimate());
    IpcRecordMaker status = make("carmen_navigator_status").number("autonomous", state.goal().isPresent() ? 1 : 0)
        .number("goal_set", state.goal().isPresent() ? 1 : 0)
        .struct("robot", here[0], here[1], here[2], state.speed().linear(), state.speed().angular());
    state.goal().ifPresent(goal -> status.struct("goal", onMap(goal)));
    return status;
  }

  IpcRecordMaker plan(RobotState state) {
    return make("carmen_navigator_plan").structs("path", state.path().stream().map(this::onMap)
        .map(at -> new double[]{at[0], at[1], at[2], 0, 0}).toList());
  }

  private IpcRecordMaker scan(String message, float[] ranges) {
    LaserSpec spec = robot.model().laser();
    float[] said = new float[ranges.length];
    for (int i = 0; i < said.length; i++) {
      said[i] = Math.min(ranges[i], (float) spec.rangeMax());
    }
    return make(message).floats("range", said).struct("config", SICK, spec.angleMin(),
        spec.increment() * (ranges.length - 1), spec.increment(), spec.rangeMax(), ACCURACY, 0);
  }

  IpcRecordMaker laser(float[] ranges) {
    return scan("carmen_laser_laser1", ranges).number("id", 1);
  }

  /** Both poses are those of odometry, as the program robot has them. */
  IpcRecordMaker frontLaser(float[] ranges, RobotState state) {
    Pose2 scanner = state.odometry().times(new Pose2(robot.model().laser().forward(), 0, 0));
    return scan("carmen_robot_frontlaser", ranges).octets("tooclose", new byte[ranges.length])
        .struct("laser_pose", numbers(scanner))
        .struct("robot_pose", numbers(state.odometry())).number("tv", state.speed().linear())
        .number("rv", state.speed().angular());
  }

  IpcRecordMaker sonars(double[] ranges) {
    return make("carmen_base_sonar").number("cone_angle", robot.model().sonars().cone()).doubles("range", ranges)
        .structs("sonar_offsets", robot.model().sonars().mounts().stream().map(CarmenRecords::numbers).toList());
  }

  IpcRecordMaker bumpers(RobotState state) {
    byte[] pressed = new byte[state.bumpers().size()];
    List<double[]> offsets = new ArrayList<>();
    for (int i = 0; i < pressed.length; i++) {
      pressed[i] = (byte) (state.bumpers().get(i) ? 1 : 0);
      BumperSpec spec = robot.model().bumpers().get(i);
      double radius = robot.model().radius();
      offsets.add(new double[]{radius * Math.cos(spec.middle()), radius * Math.sin(spec.middle())});
    }
    return make("carmen_base_bumper").octets("state", pressed).structs("bumper_offsets", offsets);
  }

  /** Column after column, as floats from 0, free, to 1; -1 is unknown. */
  IpcRecordMaker map() {
    GridMap map = robot.map();
    ByteBuffer plain = ByteBuffer.allocate(map.width() * map.height() * Float.BYTES).order(ByteOrder.LITTLE_ENDIAN);
    for (int x = 0; x < map.width(); x++) {
      for (int y = 0; y < map.height(); y++) {
        byte cell = map.at(x, y);
        plain.putFloat(cell == GridMap.UNKNOWN ? -1 : cell / CERTAIN);
      }
    }
    return make("carmen_grid_map_message").octets("data", ZlibBytes.of(plain.array())).number("compressed", 1)
        .members("config", config(map)).text("filename", "robotui");
  }

  private IpcValue.Members config(GridMap map) {
    FieldName config = forms.get("carmen_grid_map_message").fields().stream()
        .filter(field -> field.name().equals("config")).findFirst().orElseThrow();
    return new IpcValue.Members(new IpcRecord(config.members(), List.of(new IpcValue.Whole(map.width()),
        new IpcValue.Whole(map.height()), new IpcValue.Real(map.resolution()), new IpcValue.Text("robotui"))));
  }
}
