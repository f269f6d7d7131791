package org.robotui.sim.internal.roblets;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ThreadFactory;
import java.util.function.Supplier;
import org.robotui.net.socket.HostPort;
import org.robotui.roblets.brain.Brain;
import org.robotui.roblets.brain.BrainOptions;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletOptions;
import org.robotui.roblets.roblet.RobletRunner;

/** A brain on loopback, and roblets with it. */
final class SimulatedBody implements AutoCloseable {
  private final ThreadFactory threads;
  private final Brain brain;
  private final List<RobletRunner> roblets = new ArrayList<>();

  SimulatedBody(String robot, int port, ThreadFactory threads) throws IOException {
    this.threads = threads;
    this.brain = new Brain(BrainOptions.loopback(threads, port, robot));
  }

  Brain brain() {
    return brain;
  }

  String address() {
    return "127.0.0.1:" + brain.port();
  }

  RobletRunner run(Supplier<? extends Roblet> maker) throws IOException {
    RobletRunner runner =
        new RobletRunner(maker, RobletOptions.of(threads, new HostPort("127.0.0.1", brain.port())));
    roblets.add(runner);
    return runner;
  }

  @Override
  public void close() {
    roblets.forEach(RobletRunner::close);
    brain.close();
  }
}
