package org.robotui.workbench.tests;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.data.command.VelocityCommand;

/**
 * A type of robot interface without a robot, that notes which commands came, and when.
 *
 * @param commands what came, in order
 */
record Rover(List<Command> commands) implements RficType {
  static final CommandPort<VelocityCommand> DRIVE =
      new CommandPort<>("cmd_vel", VelocityCommand.class, Arity.MANY, "Drives.");

  /** A command, and when it came by the monotonic clock. */
  record Command(long nanos, VelocityCommand value) {
    boolean isZero() {
      return value.equals(VelocityCommand.ZERO);
    }
  }

  Rover() {
    this(new CopyOnWriteArrayList<>());
  }

  boolean isMoving() {
    return !commands.isEmpty() && !commands.getLast().isZero();
  }

  /** The longest time without any motion: between the last command before a zero and the next one that moves. */
  long longestStandNanos() {
    long longest = 0;
    long since = Long.MAX_VALUE;
    for (Command command : commands) {
      if (!command.isZero()) {
        longest = Math.max(longest, command.nanos() - Math.min(since, command.nanos()));
        since = Long.MAX_VALUE;
      } else {
        since = Math.min(since, command.nanos());
      }
    }
    return longest;
  }

  @Override
  public Descriptor descriptor() {
    return new Descriptor("rover", "Rover", "A robot interface of the tests.", Schema.EMPTY, List.of(DRIVE));
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return new Rfic() {
      @Override
      public void start() {
        context.offers().command(DRIVE, command -> {
          commands.add(new Command(System.nanoTime(), command));
          return new CommandSink.Sent.Out();
        });
        context.link().report(new LinkState.Connected("rover"));
      }

      @Override
      public void close() {
        // It holds nothing.
      }
    };
  }
}
