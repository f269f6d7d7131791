package org.robotui.workbench.tests;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
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
 * A type of robot interface without a robot, whose instances may hang at their end.
 *
 * @param id the word in configurations
 * @param hangs whether closing never returns
 * @param sent counts the commands that came
 */
record ProbeRfic(String id, boolean hangs, AtomicInteger sent) implements RficType {
  private static final CommandPort<VelocityCommand> DRIVE =
      new CommandPort<>("cmd_vel", VelocityCommand.class, Arity.MANY, "Drives.");

  @Override
  public Descriptor descriptor() {
    return new Descriptor(id, "Probe", "A robot interface of the tests.", Schema.EMPTY, List.of(DRIVE));
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return new Rfic() {
      @Override
      public void start() {
        context.offers().command(DRIVE, command -> {
          sent.incrementAndGet();
          return new CommandSink.Sent.Out();
        });
        context.link().report(new LinkState.Connected("probe"));
      }

      @Override
      public void close() {
        if (hangs) {
          hang();
        }
      }
    };
  }

  private static void hang() {
    CountDownLatch never = new CountDownLatch(1);
    boolean waiting = true;
    while (waiting) {
      try {
        never.await();
        waiting = false;
      } catch (InterruptedException e) {
        // A robot that hangs does not listen.
      }
    }
  }
}
