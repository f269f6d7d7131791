package org.robotui.sim;

import java.io.IOException;
import java.net.URI;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.concurrent.CountDownLatch;
import org.robotui.sim.Options.Speech;
import org.robotui.sim.internal.Events;
import org.robotui.sim.internal.Face;
import org.robotui.sim.internal.Runner;
import org.robotui.sim.internal.Sensors;
import org.robotui.sim.internal.Settings;
import org.robotui.sim.internal.SimulatedRobot;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.carmen.CarmenFace;
import org.robotui.sim.internal.lcm.LcmFace;
import org.robotui.sim.internal.player.PlayerFace;
import org.robotui.sim.internal.roblets.RobletsFace;
import org.robotui.sim.internal.ros.RosFace;
import org.robotui.sim.internal.ros2.Ros2Face;
import org.robotui.sim.internal.roboframe.RoboframeFace;
import org.robotui.sim.internal.smartsoft.SmartFace;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.MapRasterizer;
import org.robotui.sim.internal.world.World;
import org.robotui.sim.internal.yarp.YarpFace;

/** The running demo: a robot, its faces, and the thread that lets time pass. */
final class Demo implements AutoCloseable {
  private static final double MAP_RESOLUTION = 0.05;

  private final Options options;
  private final List<Face> faces = new ArrayList<>();
  private final Runner runner;
  private final CountDownLatch end = new CountDownLatch(1);
  private volatile Optional<RuntimeException> failure = Optional.empty();
  private Optional<Simulation> simulation = Optional.empty();
  private long steps;

  private Demo(Options options) {
    this.options = options;
    runner = new Runner(
        due -> step(options.ros().simTime() ? simulatedTime() : wallTime(due)), options.speedFactor(), this::fail);
  }

  /** Starts everything; the robot is offered in all its faces when this returns. */
  static Demo start(Options options) throws IOException {
    Demo demo = new Demo(options);
    try {
      demo.show();
    } catch (IOException | RuntimeException e) {
      demo.close();
      throw e;
    }
    demo.runner.start();
    return demo;
  }

  private void show() throws IOException {
    if (options.speaks().contains(Speech.ROS)) {
      faces.add(RosFace.open(options.ros(), Demo::thread, this::end));
    }
    if (options.speaks().contains(Speech.ROS2)) {
      faces.add(Ros2Face.open(options.ros(), options.domain(), Demo::thread));
    }
    if (options.speaks().contains(Speech.PLAYER)) {
      faces.add(new PlayerFace(options.playerPort(), Demo::thread));
    }
    if (options.speaks().contains(Speech.LCM)) {
      faces.add(
          new LcmFace(options.lcmUrl(), options.lcmTypes().orElseThrow(), options.ros().namespace(), Demo::thread));
    }
    if (options.speaks().contains(Speech.CARMEN)) {
      faces.add(new CarmenFace(options.carmenPort(), Demo::thread));
    }
    if (options.speaks().contains(Speech.YARP)) {
      faces.add(new YarpFace(options.yarpPort(), Demo::thread));
    }
    if (options.speaks().contains(Speech.SMARTSOFT)) {
      faces.add(new SmartFace(options.smartsoftPort(), Demo::thread));
    }
    if (options.speaks().contains(Speech.ROBLETS)) {
      faces.add(new RobletsFace(options.robletsPort(), Demo::thread));
    }
    if (options.speaks().contains(Speech.ROBOFRAME)) {
      faces.add(new RoboframeFace(options.roboframePort(), Demo::thread));
    }
    Settings settings = Settings.of(options.robot(), options.seed());
    for (Face face : faces) {
      settings = face.adjust(settings);
    }
    SimulatedRobot robot = robot(settings);
    simulation = Optional.of(robot.simulation());
    long now = options.ros().simTime() ? 0 : System.currentTimeMillis() * 1_000_000;
    for (Face face : faces) {
      face.show(robot, now);
    }
  }

  private static SimulatedRobot robot(Settings settings) {
    World world = World.of(settings.robot().building());
    GridMap map = new MapRasterizer(world, MAP_RESOLUTION, settings.laser().height()).rasterize();
    Events events = new Events();
    Simulation simulation = new Simulation(world, map, settings, events);
    return new SimulatedRobot(simulation, new Sensors(simulation), map, events);
  }

  private static Thread thread(Runnable task) {
    return Thread.ofPlatform().daemon().unstarted(task);
  }

  private void step(long stamp) {
    simulation.ifPresent(Simulation::step);
    steps++;
    faces.forEach(face -> face.step(steps, stamp));
  }

  private long simulatedTime() {
    return Math.round((steps + 1) * Simulation.STEP * 1e9);
  }

  private static long wallTime(long due) {
    return System.currentTimeMillis() * 1_000_000 - (System.nanoTime() - due);
  }

  /** The environment variables by which clients find the robot. */
  SequencedMap<String, String> addresses() {
    SequencedMap<String, String> all = new LinkedHashMap<>();
    faces.forEach(face -> all.putAll(face.addresses()));
    return all;
  }

  URI masterUri() {
    return URI.create(addresses().get("ROS_MASTER_URI"));
  }

  /** Lets {@link #awaitEnd} return. */
  void end() {
    end.countDown();
  }

  private void fail(RuntimeException cause) {
    failure = Optional.of(cause);
    end();
  }

  /**
   * Waits until something ends the demo.
   *
   * @throws IllegalStateException if that is an error of the simulation
   */
  void awaitEnd() throws InterruptedException {
    end.await();
    if (failure.isPresent()) {
      throw new IllegalStateException("the simulation failed", failure.get());
    }
  }

  @Override
  public void close() {
    end();
    runner.close();
    faces.forEach(Face::close);
  }
}
