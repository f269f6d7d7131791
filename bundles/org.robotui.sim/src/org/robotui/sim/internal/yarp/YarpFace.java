package org.robotui.sim.internal.yarp;

import java.io.IOException;
import java.net.InetAddress;
import java.util.LinkedHashMap;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.ThreadFactory;
import java.util.function.Supplier;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.Face;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.camera.CameraRenderer;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.image.YarpImage;
import org.robotui.yarp.name.NameServer;
import org.robotui.yarp.port.PortArrival;

/**
 * The robot as devices of YARP: a name server of its own on loopback, and the ports of scanner, odometry, localisation,
 * inertial unit, battery, camera, base and head, with the robot's name before them.
 */
public final class YarpFace implements Face {
  private static final double NANOS = 1e-9;
  private static final double HOLD = 0.5;
  private static final int MOTION = 3;
  private static final Rate BASE = new Rate(20);
  private static final Rate HEAD = new Rate(20);
  private static final Rate PLACE = new Rate(10);
  private static final Rate BATTERY = new Rate(1);
  private static final Rate CAMERA = new Rate(5);

  private final int port;
  private final ThreadFactory threads;
  private Optional<NameServer> server = Optional.empty();
  private Optional<Shown> shown = Optional.empty();

  /** What there is once the robot is shown. */
  private record Shown(SimulatedRobot robot, YarpBench bench, YarpSayings says, CameraRenderer studio,
      Optional<ControlBoard> head) {}

  /** @param port where the name server listens; 0 for a free one */
  public YarpFace(int port, ThreadFactory threads) {
    this.port = port;
    this.threads = threads;
  }

  @Override
  public void show(SimulatedRobot robot, long stamp) throws IOException {
    NameServer opened = new NameServer(InetAddress.getLoopbackAddress(), port, threads);
    server = Optional.of(opened);
    YarpBench bench = new YarpBench("/" + robot.model().name(), opened, threads);
    for (String name : new String[]{"odo/odometry:o", "laser", "localization/streaming:o", "imu/measures:o",
        "battery/data:o", "camera"}) {
      bench.says(name);
    }
    bench.asked("battery/rpc:i", YarpFace::nak);
    bench.asked("camera/rpc", YarpFace::nak);
    bench.asked("laser/rpc:i", YarpFace::nak);
    bench.asked("base/rpc:i", asked -> velocity(robot, asked));
    bench.hears("base/data:i", told -> drive(robot, told.bottle()));
    Optional<ControlBoard> head = robot.state().head().map(at -> new ControlBoard(new HeadJoints(robot)));
    if (head.isPresent()) {
      bench.board("head", head.get());
    }
    shown = Optional.of(new Shown(robot, bench, new YarpSayings(robot),
        new CameraRenderer(robot.simulation().world(), robot.model().lens()), head));
  }

  private static Bottle nak(PortArrival arrival) {
    return Bottle.of(Bottle.vocabs("nak"));
  }

  /** {@code applyVelocityCommandRPC x y turn seconds}, turning in degrees. */
  private static Bottle velocity(SimulatedRobot robot, PortArrival asked) {
    Bottle bottle = asked.bottle();
    boolean known = bottle.get(0).text().equals("applyVelocityCommandRPC") && bottle.size() > MOTION;
    if (known) {
      drive(robot, Bottle.of(bottle.values().subList(1, bottle.size())));
    }
    return Bottle.of(Bottle.vocabs(known ? "ok" : "fail"));
  }

  private static void drive(SimulatedRobot robot, Bottle told) {
    Speed speed = new Speed(told.get(0).number(), Math.toRadians(told.get(2).number()));
    if (told.size() >= MOTION && speed.isFinite()) {
      robot.simulation().submit(new Command.Drive(speed, HOLD));
    }
  }

  @Override
  public void step(long step, long stamp) {
    shown.ifPresent(all -> step(all, step, stamp * NANOS));
  }

  private static void step(Shown all, long step, double now) {
    YarpBench bench = all.bench();
    RobotState state = all.robot().state();
    say(BASE.isDue(step), bench, "odo/odometry:o", now, () -> all.says().odometry(state));
    say(BASE.isDue(step), bench, "imu/measures:o", now, () -> all.says().imu(now));
    say(PLACE.isDue(step), bench, "localization/streaming:o", now, () -> all.says().place(state));
    say(BATTERY.isDue(step), bench, "battery/data:o", now, () -> all.says().battery(state));
    say(all.robot().sensors().isScanDue(step), bench, "laser", now,
        () -> all.says().scan(all.robot().sensors().scan(step)));
    if (HEAD.isDue(step)) {
      all.head().ifPresent(board -> bench.say("head", board, now));
    }
    if (CAMERA.isDue(step) && bench.isHeard("camera")) {
      all.studio().offer(state, shot -> bench.say("camera", YarpImage.of("rgb", 3, all.studio().lens().width(),
          all.studio().lens().height(), shot.rgb()).toBottle(), now));
    }
  }

  private static void say(boolean due, YarpBench bench, String name, double now, Supplier<Bottle> what) {
    if (due) {
      bench.sayIfHeard(name, what, now);
    }
  }

  @Override
  public SequencedMap<String, String> addresses() {
    SequencedMap<String, String> variables = new LinkedHashMap<>();
    server.ifPresent(listening -> variables.put("YARP_NAMESERVER", "127.0.0.1:" + listening.port()));
    return variables;
  }

  @Override
  public void close() {
    shown.ifPresent(all -> {
      all.bench().close();
      all.studio().close();
    });
    server.ifPresent(NameServer::close);
  }
}
