package org.robotui.sim.internal.player;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.IntConsumer;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Layouts;
import org.robotui.player.server.PlayerServer;
import org.robotui.player.server.ServedDevice;
import org.robotui.player.server.TypedHandler;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.SimulatedRobot;

/** What devices are made with. Any thread may use it. */
record Bench(Layouts layouts, PlayerServer server, SimulatedRobot robot) {
  private static final String DRIVER = "robotui";
  private static final long PATIENCE_SECONDS = 2;

  RobotState state() {
    return robot.state();
  }

  TypedHandler handler() {
    return handler(clients -> {});
  }

  TypedHandler handler(IntConsumer clients) {
    return new TypedHandler(layouts, clients);
  }

  ServedDevice add(String interfaceName, int index, TypedHandler handler) {
    return server.add(interfaceName, index, DRIVER, handler);
  }

  /** Asks for something and does not wait. */
  void submit(Command command) {
    robot.simulation().submit(command);
  }

  /** Lets the robot do something; empty, which refuses a request, unless it did. */
  Optional<Empty> done(Command command) {
    CountDownLatch done = new CountDownLatch(1);
    try {
      boolean taken =
          robot.simulation().submit(command, done::countDown) && done.await(PATIENCE_SECONDS, TimeUnit.SECONDS);
      return taken ? Optional.of(new Empty()) : Optional.empty();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    }
  }
}
