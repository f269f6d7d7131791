package org.robotui.sim.internal.swarm;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.RosNode;
import org.robotui.sim.internal.ros.DemoMaster;
import org.robotui.sim.internal.ros.RosOptions;

/**
 * Many cheap robots at one master, in namespaces {@code r1}, {@code r2} and so on: each a node with odometry,
 * transforms, a scan of few beams and a battery, which takes velocities and goals. One thread lets time pass for all.
 */
public final class Swarm implements AutoCloseable {
  /** As many as one process carries. */
  public static final int MOST = 200;

  private static final Duration REGISTRATION = Duration.ofSeconds(30);
  private static final long STEP_NANOS = 50_000_000L;
  private static final double STEP = STEP_NANOS / 1e9;

  private final DemoMaster master;
  private final List<RosNode> nodes;
  private final List<SwarmRobot> robots;
  private final CountDownLatch end = new CountDownLatch(1);
  private final Thread time;
  private volatile boolean closed;

  private Swarm(DemoMaster master, List<RosNode> nodes, List<SwarmRobot> robots) {
    this.master = master;
    this.nodes = List.copyOf(nodes);
    this.robots = new ArrayList<>(robots);
    this.time = Thread.ofPlatform().name("swarm").daemon().unstarted(this::run);
  }

  /**
   * Starts a swarm; all is advertised when this returns.
   *
   * @param count how many robots, at most {@link #MOST}
   * @param options say at which master
   * @param seed of where they stand and go
   */
  public static Swarm start(int count, RosOptions options, long seed) throws IOException {
    DemoMaster master = DemoMaster.open(options, Swarm::thread);
    List<RosNode> nodes = new ArrayList<>();
    try {
      Swarm swarm = start(count, seed, master, nodes);
      swarm.time.start();
      return swarm;
    } catch (IOException | RuntimeException e) {
      nodes.forEach(RosNode::close);
      master.close();
      throw e;
    }
  }

  private static Swarm start(int count, long seed, DemoMaster master, List<RosNode> nodes) throws IOException {
    Hall hall = Hall.forRobots(count);
    HallMap.publish(open(master, "/", "map_server", nodes), hall, System.currentTimeMillis() * 1_000_000);
    List<SwarmRobot> robots = new ArrayList<>();
    int rows = (int) Math.ceil(Math.sqrt(count * Hall.HEIGHT / hall.width()));
    int columns = (count + rows - 1) / rows;
    for (int i = 0; i < count; i++) {
      String name = "r" + (i + 1);
      double x = hall.width() * (i % columns + 0.5) / columns;
      double y = Hall.HEIGHT * (i / columns + 0.5) / rows;
      robots.add(
          new SwarmRobot(name, open(master, "/" + name, "robot", nodes), walker(hall, x, y, new Random(seed + i))));
    }
    for (RosNode node : nodes) {
      if (!node.awaitRegistered(REGISTRATION)) {
        throw new IOException("the master did not take " + node.name() + " within " + REGISTRATION.toSeconds() + " s");
      }
    }
    return new Swarm(master, nodes, robots);
  }

  /** On a free place next to one. */
  private static Walker walker(Hall hall, double x, double y, Random random) {
    double freeX = x;
    while (!hall.isFree(freeX, y, Walker.RADIUS + 0.1)) {
      freeX = freeX > hall.width() - 1 ? 1 : freeX + 0.3;
    }
    return new Walker(hall, freeX, y, random);
  }

  private static RosNode open(DemoMaster master, String namespace, String name, List<RosNode> nodes)
      throws IOException {
    RosNode node = RosNode.open(master.environment(List.of("__ns:=" + namespace)), GraphName.of(name),
        NodeOptions.standard(Swarm::thread));
    nodes.add(node);
    return node;
  }

  private static Thread thread(Runnable task) {
    return Thread.ofPlatform().daemon().unstarted(task);
  }

  private void run() {
    long due = System.nanoTime();
    for (long step = 0; !closed; step++) {
      due = Math.max(due + STEP_NANOS, System.nanoTime() - STEP_NANOS);
      step(step);
      LockSupport.parkNanos(due - System.nanoTime());
    }
  }

  private void step(long step) {
    robots.removeIf(SwarmRobot::isGone);
    List<Walker> all = robots.stream().map(SwarmRobot::walker).toList();
    all.forEach(w -> w.step(STEP, all));
    long stamp = System.currentTimeMillis() * 1_000_000;
    for (int i = 0; i < robots.size(); i++) {
      robots.get(i).publish(step + i, stamp, all);
    }
  }

  /** Their master. */
  public DemoMaster master() {
    return master;
  }

  /** Lets {@link #awaitEnd} return. */
  public void end() {
    end.countDown();
  }

  /** Waits until somebody ends it. */
  public void awaitEnd() throws InterruptedException {
    end.await();
  }

  @Override
  public void close() {
    closed = true;
    end();
    LockSupport.unpark(time);
    nodes.parallelStream().forEach(RosNode::close);
    master.close();
  }
}
