package org.robotui.sim.internal.roboframe;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.ThreadFactory;
import java.util.function.Supplier;
import org.robotui.message.roboframe.BatteryStreamable;
import org.robotui.message.roboframe.GridStreamable;
import org.robotui.message.roboframe.OdometryStreamable;
import org.robotui.message.roboframe.PictureStreamable;
import org.robotui.message.roboframe.PoseStreamable;
import org.robotui.message.roboframe.ScanStreamable;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.roboframe.app.RoboApplication;
import org.robotui.roboframe.board.Blackboard;
import org.robotui.roboframe.board.Connector;
import org.robotui.roboframe.board.KeyOutput;
import org.robotui.sim.internal.Face;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.camera.CameraRenderer;
import org.robotui.sim.internal.sensor.LaserSpec;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.Pose2;

/**
 * The robot as an application of RoboFrame that listens on loopback: its sensors write keys, and modules drive,
 * navigate and see a ball.
 */
public final class RoboframeFace implements Face {
  private static final Rate BASE = new Rate(20);
  private static final Rate PLACE = new Rate(10);
  private static final Rate BATTERY = new Rate(1);
  private static final Rate CAMERA = new Rate(5);

  private final int port;
  private final ThreadFactory threads;
  private Optional<RoboApplication> application = Optional.empty();
  private Optional<Shown> shown = Optional.empty();
  private volatile long now;

  /** What there is once the robot is shown. */
  private record Shown(SimulatedRobot robot, RoboframePlaces places, CameraRenderer studio,
      KeyOutput<OdometryStreamable> odometry, KeyOutput<ScanStreamable> scan, KeyOutput<PoseStreamable> pose,
      KeyOutput<TFMessage> frames, KeyOutput<BatteryStreamable> battery, KeyOutput<PictureStreamable> picture) {}

  /** @param port where the application listens; 0 for a free one */
  public RoboframeFace(int port, ThreadFactory threads) {
    this.port = port;
    this.threads = threads;
  }

  @Override
  public void show(SimulatedRobot robot, long stamp) throws IOException {
    now = stamp;
    RoboApplication opened = new RoboApplication(robot.model().name(),
        List.of(new Connector.Listen(InetAddress.getLoopbackAddress(), port)), threads);
    application = Optional.of(opened);
    Blackboard board = opened.blackboard();
    shown = Optional.of(new Shown(robot, new RoboframePlaces(robot.model()),
        new CameraRenderer(robot.simulation().world(), robot.model().lens()),
        board.advertise(RoboframeKeys.ODOMETRY, "wheels"), board.advertise(RoboframeKeys.SCAN, "laser"),
        board.advertise(RoboframeKeys.POSE, "localisation"), board.advertise(RoboframeKeys.FRAMES, "localisation"),
        board.advertise(RoboframeKeys.BATTERY, "energy"), board.advertise(RoboframeKeys.PICTURE, "camera")));
    board.advertise(RoboframeKeys.MAP, "localisation").push(map(robot.map(), stamp));
    opened.add("drive", () -> new RoboframeModules.Drive(robot));
    opened.add("navigation", () -> new RoboframeModules.Navigation(robot));
    Pose2 ball = robot.state().estimate().times(new Pose2(1.5, 0.5, 0));
    opened.add("team", RoboframeModules.Team::new);
    opened.add("vision", () -> new RoboframeModules.Vision(robot.model().name(), ball, () -> now));
  }

  /** Does not change, and so stands on the blackboard for whoever asks later. */
  private static GridStreamable map(GridMap map, long stamp) {
    return new GridStreamable(stamp, "map", map.resolution(), map.width(), map.height(), map.originX(), map.originY(),
        ByteBuffer.wrap(map.cells()));
  }

  @Override
  public void step(long step, long stamp) {
    now = stamp;
    shown.ifPresent(all -> step(all, step, stamp, all.robot().state()));
  }

  private static void step(Shown all, long step, long stamp, RobotState state) {
    push(BASE.isDue(step), all.odometry(), () -> odometry(state, stamp));
    push(PLACE.isDue(step), all.pose(), () -> {
      Pose2 here = state.estimate();
      return new PoseStreamable(stamp, "map", here.x(), here.y(), here.yaw());
    });
    push(BASE.isDue(step), all.frames(), () -> all.places().message(state, stamp));
    push(BATTERY.isDue(step), all.battery(), () -> battery(state.battery(), stamp));
    push(all.robot().sensors().isScanDue(step), all.scan(), () -> scan(all.robot(), step, stamp));
    if (CAMERA.isDue(step) && all.picture().readers() > 0) {
      all.studio().offer(state, shot -> all.picture()
          .push(new PictureStreamable(stamp, RoboframePlaces.OPTICS, "jpeg", ByteBuffer.wrap(shot.jpeg()))));
    }
  }

  /** Made only where somebody reads it. */
  private static <T> void push(boolean due, KeyOutput<T> output, Supplier<T> value) {
    if (due && output.readers() > 0) {
      output.push(value.get());
    }
  }

  private static OdometryStreamable odometry(RobotState state, long stamp) {
    Pose2 at = state.odometry();
    return new OdometryStreamable(stamp, RoboframePlaces.ODOMETRY, RoboframePlaces.BASE, at.x(), at.y(), at.yaw(),
        state.speed().linear(), 0, state.speed().angular());
  }

  private static BatteryStreamable battery(RobotState.BatteryReading battery, long stamp) {
    return new BatteryStreamable(stamp, battery.voltage(), battery.current(), battery.level(), battery.charging());
  }

  private static ScanStreamable scan(SimulatedRobot robot, long step, long stamp) {
    LaserSpec laser = robot.model().laser();
    return new ScanStreamable(stamp, RoboframePlaces.LASER, (float) laser.angleMin(), (float) laser.increment(),
        (float) laser.rangeMin(), (float) laser.rangeMax(), robot.sensors().scan(step));
  }

  @Override
  public SequencedMap<String, String> addresses() {
    SequencedMap<String, String> variables = new LinkedHashMap<>();
    application.ifPresent(
        opened -> variables.put("ROBOFRAME_ADDR", "127.0.0.1:" + opened.router().ports().getFirst()));
    return variables;
  }

  @Override
  public void close() {
    application.ifPresent(RoboApplication::close);
    shown.ifPresent(all -> all.studio().close());
  }
}
