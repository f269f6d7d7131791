package org.robotui.sim.internal.carmen;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.ThreadFactory;
import java.util.stream.IntStream;
import org.robotui.carmen.central.CentralOptions;
import org.robotui.carmen.central.IpcCentral;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.module.IpcModule;
import org.robotui.carmen.module.ModuleOptions;
import org.robotui.carmen.module.ParamDaemon;
import org.robotui.net.socket.HostPort;
import org.robotui.sim.internal.Face;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.world.Pose2;

/**
 * The robot as programs of CARMEN: a central of its own on loopback, and a module that says and takes what base,
 * simulator, robot, localize, map, navigator and the parameter daemon do.
 */
public final class CarmenFace implements Face {
  static final String HOST = "robot";
  private static final double NANOS = 1e-9;
  private static final Rate BASE = new Rate(20);
  private static final Rate SONAR = new Rate(10);
  private static final Rate BUMPER = new Rate(20);
  private static final Rate PLACE = new Rate(5);
  private static final Rate PARTICLES = new Rate(1);
  private static final Rate STATUS = new Rate(2);
  private static final Rate HEARTBEAT = new Rate(1);

  private final int port;
  private final ThreadFactory threads;
  private final IpcForms forms = IpcForms.carmen();
  private Optional<IpcCentral> central = Optional.empty();
  private Optional<IpcModule> module = Optional.empty();
  private Optional<Shown> shown = Optional.empty();
  private volatile double now;
  private List<Pose2> lastPath = List.of();

  /** What there is once the robot is shown. */
  private record Shown(SimulatedRobot robot, CarmenRecords records, Said said) {}

  /** @param port where the central listens; 0 for a free one */
  public CarmenFace(int port, ThreadFactory threads) {
    this.port = port;
    this.threads = threads;
  }

  @Override
  public void show(SimulatedRobot robot, long stamp) throws IOException {
    now = stamp * NANOS;
    IpcCentral opened = new IpcCentral(CentralOptions.loopback(threads, port));
    central = Optional.of(opened);
    IpcModule linked =
        IpcModule.connect(new HostPort("127.0.0.1", opened.port()), forms, ModuleOptions.of(HOST, threads));
    module = Optional.of(linked);
    CarmenRecords records = new CarmenRecords(forms, robot, () -> now);
    Said said = new Said(linked, forms, records.names());
    new ParamDaemon(linked, forms, () -> now, HOST, parameters(robot));
    new CarmenOrders(linked, forms, robot, records);
    shown = Optional.of(new Shown(robot, records, said));
  }

  private static Map<String, Map<String, String>> parameters(SimulatedRobot robot) {
    return Map.of("robot", Map.of("max_t_vel", Double.toString(robot.simulation().settings().limits().linear()),
        "max_r_vel", Double.toString(robot.simulation().settings().limits().angular()),
        "width", Double.toString(2 * robot.model().radius()), "length", Double.toString(2 * robot.model().radius()),
        "frontlaser_offset", Double.toString(robot.model().laser().forward()), "use_laser", "on",
        "use_sonar", robot.model().sonars().count() > 0 ? "on" : "off"));
  }

  @Override
  public void step(long step, long stamp) {
    now = stamp * NANOS;
    shown.ifPresent(all -> step(all, step, all.robot().state()));
  }

  private void step(Shown all, long step, RobotState state) {
    CarmenRecords records = all.records();
    Said said = all.said();
    if (BASE.isDue(step)) {
      said.say(records.odometry(state));
      said.say(records.truth(state));
      said.say(records.imu());
    }
    if (HEARTBEAT.isDue(step)) {
      said.say(records.heartbeat());
    }
    if (PLACE.isDue(step)) {
      said.say(records.place(state));
    }
    if (PARTICLES.isDue(step)) {
      said.say(records.particles(state));
    }
    if (STATUS.isDue(step) || !state.path().equals(lastPath)) {
      said.say(records.status(state));
      said.say(records.plan(state));
      lastPath = state.path();
    }
    sense(all, step, state);
  }

  private static void sense(Shown all, long step, RobotState state) {
    SimulatedRobot robot = all.robot();
    if (robot.sensors().isScanDue(step)) {
      float[] ranges = robot.sensors().scan(step);
      all.said().say(all.records().laser(ranges));
      all.said().say(all.records().frontLaser(ranges, state));
    }
    int sonars = robot.model().sonars().count();
    if (sonars > 0 && SONAR.isDue(step)) {
      all.said().say(
          all.records().sonars(IntStream.range(0, sonars).mapToDouble(robot.sensors()::sonar).toArray()));
    }
    if (!state.bumpers().isEmpty() && BUMPER.isDue(step)) {
      all.said().say(all.records().bumpers(state));
    }
  }

  @Override
  public SequencedMap<String, String> addresses() {
    SequencedMap<String, String> variables = new LinkedHashMap<>();
    central.ifPresent(listening -> variables.put("CENTRALHOST", "127.0.0.1:" + listening.port()));
    return variables;
  }

  @Override
  public void close() {
    module.ifPresent(IpcModule::close);
    central.ifPresent(IpcCentral::close);
  }
}
