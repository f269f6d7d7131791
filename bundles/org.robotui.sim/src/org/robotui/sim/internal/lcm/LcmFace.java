package org.robotui.sim.internal.lcm;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.ThreadFactory;
import java.util.stream.IntStream;
import org.robotui.lcm.LcmUrl;
import org.robotui.sim.internal.Face;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.camera.CameraRenderer;
import org.robotui.sim.internal.world.Pose2;

/** The robot as messages on LCM's channels, which are sent whether or not somebody listens, as LCM cannot tell. */
public final class LcmFace implements Face {
  private static final Rate POSE = new Rate(10);
  private static final Rate ODOMETRY = new Rate(50);
  private static final Rate SONAR = new Rate(10);
  private static final Rate BUMPER = new Rate(20);
  private static final Rate BATTERY = new Rate(1);
  private static final Rate CAMERA = new Rate(10);
  private static final Rate MAP = new Rate(0.2);
  private static final Rate PATH = new Rate(1);
  private static final Rate GOAL_STATUS = new Rate(5);
  private static final long NANOS_A_MICROSECOND = 1000;

  private final Optional<LcmUrl> url;
  private final Types types;
  private final String namespace;
  private final ThreadFactory threads;
  private Optional<LcmTransport> air = Optional.empty();
  private Optional<Shown> shown = Optional.empty();
  private volatile long utime;
  private List<Pose2> lastPath = List.of();

  /** What there is once the robot is shown. */
  private record Shown(SimulatedRobot robot, Channels channels, LcmRecords telling, CameraRenderer studio) {}

  /**
   * Reads the types.
   *
   * @param url where messages go; else multicast on a free port of this machine
   * @param folder with the types of the package {@code robotui}
   * @param namespace with which the names of channels begin, empty for none
   * @throws IOException if the types cannot be read
   */
  public LcmFace(Optional<URI> url, Path folder, String namespace, ThreadFactory threads) throws IOException {
    this.url = url.map(text -> LcmUrl.of(text.toString()));
    this.types = Types.read(folder);
    this.namespace = namespace;
    this.threads = threads;
  }

  @Override
  public void show(SimulatedRobot robot, long stamp) throws IOException {
    utime = stamp / NANOS_A_MICROSECOND;
    LcmTransport opened = LcmTransport.open(url, threads);
    air = Optional.of(opened);
    Channels channels = new Channels(opened.lcm(), types, namespace);
    LcmRecords telling = new LcmRecords(types, robot);
    robot.events().listen(event -> channels.send("LOG", telling.log(event, utime)));
    new Commands(robot, channels);
    shown = Optional
        .of(new Shown(robot, channels, telling, new CameraRenderer(robot.simulation().world(), robot.model().lens())));
  }

  @Override
  public void step(long step, long stamp) {
    utime = stamp / NANOS_A_MICROSECOND;
    shown.ifPresent(all -> step(all, step, all.robot().state()));
  }

  private void step(Shown all, long step, RobotState state) {
    Channels to = all.channels();
    LcmRecords telling = all.telling();
    long now = utime;
    if (ODOMETRY.isDue(step)) {
      to.send("ODOMETRY", telling.odometry(state, now));
      to.send("TRANSFORMS", telling.transforms(state, now));
      to.send("IMU", telling.imu(all.robot().simulation().imu(), now));
    }
    if (POSE.isDue(step)) {
      to.send("POSE", telling.pose(state, now));
    }
    if (GOAL_STATUS.isDue(step)) {
      to.send("GOAL_STATUS", telling.goalStatus(state.goalStatus(), now));
    }
    if (BATTERY.isDue(step)) {
      to.send("BATTERY", telling.battery(state, now));
    }
    if (step == 1 || MAP.isDue(step)) {
      to.send("MAP", telling.map(all.robot().map(), now));
    }
    path(all, step, state, now);
    sense(all, step, state, now);
  }

  private void path(Shown all, long step, RobotState state, long now) {
    if (PATH.isDue(step) || !state.path().equals(lastPath)) {
      lastPath = state.path();
      all.channels().send("PATH", all.telling().path(state, now));
    }
  }

  private void sense(Shown all, long step, RobotState state, long now) {
    SimulatedRobot robot = all.robot();
    if (robot.sensors().isScanDue(step)) {
      all.channels().send("LASER", all.telling().laser(robot.sensors().scan(step), now));
    }
    int sonars = robot.model().sonars().count();
    if (sonars > 0 && SONAR.isDue(step)) {
      double[] ranges = IntStream.range(0, sonars).mapToDouble(robot.sensors()::sonar).toArray();
      all.channels().send("SONAR", all.telling().sonar(ranges, now));
    }
    if (!state.bumpers().isEmpty() && BUMPER.isDue(step)) {
      all.channels().send("BUMPER", all.telling().bumper(state, now));
    }
    if (CAMERA.isDue(step)) {
      all.studio().offer(state, shot -> all.channels().send("CAMERA", all.telling().picture(shot.jpeg(), now)));
    }
  }

  @Override
  public SequencedMap<String, String> addresses() {
    SequencedMap<String, String> variables = new LinkedHashMap<>();
    air.ifPresent(opened -> variables.put(LcmUrl.VARIABLE, opened.lcm().url().toString()));
    return variables;
  }

  @Override
  public void close() {
    shown.ifPresent(all -> all.studio().close());
    air.ifPresent(LcmTransport::close);
  }
}
