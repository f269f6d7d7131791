package org.robotui.sim.internal.roblets;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.robotui.roblets.brain.Brain;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.sim.internal.roblets.BoatMessages.Motion;
import org.robotui.sim.internal.roblets.BoatMessages.Position;
import org.robotui.sim.internal.roblets.BoatMessages.Wind;

/** The boat of the paper: nine roblets and a brain that steers from mark to mark, and a thread that lets time pass. */
public final class BoatDemo implements AutoCloseable {
  private static final long STEP_MILLIS = 20;

  private final SimulatedBody body;
  private final Boat boat;
  private final CountDownLatch end = new CountDownLatch(1);
  private final Thread time;

  private BoatDemo(int port, long seed) throws IOException {
    body = new SimulatedBody("boat", port, BoatDemo::thread);
    boat = new Boat(seed);
    time = thread(this::sail);
  }

  /** @param port of the brain on loopback; 0 for a free one */
  public static BoatDemo start(int port, long seed) throws IOException {
    BoatDemo demo = new BoatDemo(port, seed);
    try {
      demo.launch();
    } catch (IOException | RuntimeException e) {
      demo.body.close();
      throw e;
    }
    demo.time.start();
    return demo;
  }

  private void launch() throws IOException {
    for (Supplier<Roblet> maker : roblets(boat)) {
      body.run(maker);
    }
    body.brain().rule(BoatPilot.rule());
  }

  /** What makes the organs of a boat. */
  static List<Supplier<Roblet>> roblets(Boat boat) {
    return List.of(() -> new SayingRoblet<>("gps", 5, Position.class, boat::position),
        () -> CommonRoblets.compass(boat::heading), () -> new SayingRoblet<>("wind", 4, Wind.class, boat::wind),
        () -> new SayingRoblet<>("log", 20, Motion.class, boat::motion), () -> CommonRoblets.battery(boat::charge),
        CommonRoblets.HeartRoblet::new, () -> new RudderRoblet(boat), () -> new MotorRoblet(boat), HelmRoblet::new);
  }

  private static Thread thread(Runnable task) {
    return Thread.ofPlatform().daemon().unstarted(task);
  }

  private void sail() {
    try {
      long last = System.nanoTime();
      while (!end.await(STEP_MILLIS, TimeUnit.MILLISECONDS)) {
        long now = System.nanoTime();
        boat.step(Math.min(0.1, (now - last) / 1e9));
        last = now;
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Where clients find it. */
  public String address() {
    return body.address();
  }

  Brain brain() {
    return body.brain();
  }

  /** Lets {@link #awaitEnd} return. */
  public void end() {
    end.countDown();
  }

  public void awaitEnd() throws InterruptedException {
    end.await();
  }

  @Override
  public void close() {
    end();
    body.close();
  }
}
