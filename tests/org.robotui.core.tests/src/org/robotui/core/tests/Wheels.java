package org.robotui.core.tests;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.data.command.VelocityCommand;

/**
 * A type of a healthy robot interface: it tells of a battery a hundred times a second and notes which commands came,
 * and when.
 *
 * @param id the word in configurations
 * @param commands what came, in order
 */
record Wheels(String id, List<Command> commands) implements RficType {
  /** A command, and when it came by the monotonic clock. */
  record Command(long nanos, VelocityCommand value) {
    boolean isZero() {
      return value.equals(VelocityCommand.ZERO);
    }
  }

  static final CommandPort<VelocityCommand> DRIVE =
      new CommandPort<>("cmd_vel", VelocityCommand.class, Arity.MANY, "Drives.");

  Wheels(String id) {
    this(id, new CopyOnWriteArrayList<>());
  }

  void awaitMoving() {
    Eventually.await(id + " moves", () -> !commands.isEmpty() && !commands.getLast().isZero(), commands::size);
  }

  /** Waits until it has been stopped, and says when the zero came after which nothing else came. */
  long awaitStopped() {
    Eventually.await(id + " is stopped", () -> !commands.isEmpty() && commands.getLast().isZero(), commands::size);
    return commands.reversed().stream().takeWhile(Command::isZero).reduce((a, b) -> b).orElseThrow().nanos();
  }

  @Override
  public Descriptor descriptor() {
    return new Descriptor(id, "Wheels", "A robot of the tests.", new FakeRobot(id).schema(), List.of());
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    Rfic telling = new FakeRobot(id).create(context, settings);
    return new Rfic() {
      @Override
      public void start() {
        context.offers().command(DRIVE, command -> {
          commands.add(new Command(System.nanoTime(), command));
          return new CommandSink.Sent.Out();
        });
        telling.start();
      }

      @Override
      public void close() {
        telling.close();
      }
    };
  }
}
