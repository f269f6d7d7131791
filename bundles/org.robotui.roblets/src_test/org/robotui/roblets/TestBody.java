package org.robotui.roblets;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ThreadFactory;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.robotui.net.socket.HostPort;
import org.robotui.roblets.brain.Brain;
import org.robotui.roblets.brain.BrainOptions;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletOptions;
import org.robotui.roblets.roblet.RobletRunner;

/** A brain on a free port, and roblets with it. */
final class TestBody implements AutoCloseable {
  static final ThreadFactory THREADS = Thread.ofPlatform().daemon().factory();

  private final List<AutoCloseable> running = new ArrayList<>();
  private final int port;
  private Brain brain;

  TestBody() throws IOException {
    brain = new Brain(BrainOptions.loopback(THREADS, 0, "test"));
    port = brain.port();
  }

  Brain brain() {
    return brain;
  }

  void restartBrain() throws IOException {
    brain.close();
    brain = new Brain(BrainOptions.loopback(THREADS, port, "test"));
  }

  RobletRunner run(Supplier<? extends Roblet> maker) throws IOException {
    return run(maker, port);
  }

  RobletRunner run(Supplier<? extends Roblet> maker, int towards) throws IOException {
    RobletOptions usual = RobletOptions.of(THREADS, new HostPort("127.0.0.1", towards));
    // long enough that a test on a loaded machine sees a roblet that has failed
    RobletRunner runner =
        new RobletRunner(maker, new RobletOptions(THREADS, usual.brain(), usual.own(), Duration.ofSeconds(2)));
    running.add(runner);
    return runner;
  }

  BadNetwork badNetwork() throws IOException {
    BadNetwork network = new BadNetwork(port);
    running.add(network);
    return network;
  }

  void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + Duration.ofSeconds(60).toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() - end < 0, () -> what + ": " + brain.roblets() + brain.bodymap().snapshot().tree());
      try {
        Thread.sleep(5);
      } catch (InterruptedException e) {
        throw new AssertionError(e);
      }
    }
  }

  @Override
  public void close() {
    try {
      for (AutoCloseable each : running) {
        each.close();
      }
    } catch (Exception e) {
      throw new AssertionError(e);
    }
    brain.close();
  }
}
