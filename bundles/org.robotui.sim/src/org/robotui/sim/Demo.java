package org.robotui.sim;

import java.io.IOException;
import java.net.URI;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.master.MasterOptions;
import org.robotui.ros.master.RosMaster;
import org.robotui.sim.internal.Runner;
import org.robotui.sim.internal.Settings;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.ros.RobotNode;
import org.robotui.sim.internal.world.World;

/** The running demo: a master, a robot at it, and the thread that lets time pass. */
final class Demo implements AutoCloseable {
  private static final Duration REGISTRATION = Duration.ofSeconds(20);

  private final Optional<RosMaster> master;
  private final URI masterUri;
  private final RobotNode robot;
  private final Runner runner;
  private final CountDownLatch end = new CountDownLatch(1);
  private volatile Optional<RuntimeException> failure = Optional.empty();
  private long steps;

  private Demo(Optional<RosMaster> master, URI masterUri, RobotNode robot, Options options) {
    this.master = master;
    this.masterUri = masterUri;
    this.robot = robot;
    runner = new Runner(
        due -> robot.step(options.simTime() ? simulatedTime() : wallTime(due)), options.speedFactor(), this::fail);
  }

  /** Starts everything; the robot is advertised when this returns. */
  static Demo start(Options options) throws IOException {
    Optional<RosMaster> master = options.realMaster().isPresent()
        ? Optional.empty()
        : Optional.of(RosMaster.open(MasterOptions.standard(Demo::thread).withPort(options.port())));
    URI uri = options.realMaster().or(() -> master.map(RosMaster::uri)).orElseThrow();
    GraphName name = GraphName.of(options.name());
    RosNode node = RosNode.open(environment(options, uri), name, NodeOptions.standard(Demo::thread));
    try {
      return start(options, master, uri, node);
    } catch (IOException | RuntimeException e) {
      node.close();
      master.ifPresent(RosMaster::close);
      throw e;
    }
  }

  private static Demo start(Options options, Optional<RosMaster> master, URI uri, RosNode node) throws IOException {
    awaitMaster(node, uri);
    long now = options.simTime() ? 0 : System.currentTimeMillis() * 1_000_000;
    RobotNode robot = RobotNode.start(node, World.demo(), Settings.demo(options.seed()), options.simTime(), now);
    awaitMaster(node, uri);
    Demo demo = new Demo(master, uri, robot, options);
    node.whenClosed().thenRun(demo::end);
    demo.runner.start();
    return demo;
  }

  /** The first time for the parameters of the command line, which the robot reads; then for all it advertises. */
  private static void awaitMaster(RosNode node, URI master) throws IOException {
    if (!node.awaitRegistered(REGISTRATION)) {
      throw new IOException(
          "the master at " + master + " did not take the robot within " + REGISTRATION.toSeconds() + " s");
    }
  }

  private static Thread thread(Runnable task) {
    return Thread.ofPlatform().daemon().unstarted(task);
  }

  private static RosEnvironment environment(Options options, URI master) {
    Map<String, String> variables = new HashMap<>();
    if (options.realMaster().isPresent()) {
      variables.putAll(System.getenv());
    }
    variables.put("ROS_MASTER_URI", master.toString());
    List<String> arguments = new ArrayList<>(options.rosArguments());
    if (!options.namespace().isEmpty()) {
      arguments.add("__ns:=/" + options.namespace());
    }
    return RosEnvironment.of(variables, arguments);
  }

  private long simulatedTime() {
    steps++;
    return Math.round(steps * Simulation.STEP * 1e9);
  }

  private static long wallTime(long due) {
    return System.currentTimeMillis() * 1_000_000 - (System.nanoTime() - due);
  }

  URI masterUri() {
    return masterUri;
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
    robot.close();
    master.ifPresent(RosMaster::close);
  }
}
