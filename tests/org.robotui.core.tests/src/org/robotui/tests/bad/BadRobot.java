package org.robotui.tests.bad;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.CommandSink;
import org.robotui.api.port.Publication;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.StreamPort;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.record.DataRecord;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;

/**
 * The type of a robot interface that misbehaves in {@code create}, {@code start}, {@code thread}, {@code send},
 * {@code call}, {@code demand} or {@code close}, or publishes without end.
 */
final class BadRobot implements RficType {
  private static final CommandPort<VelocityCommand> DRIVE =
      new CommandPort<>("cmd_vel", VelocityCommand.class, Arity.MANY, "Drives.");
  private static final CallPort<ServiceRequest, ServiceReply> SERVICES =
      new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY, "Asks.");
  private static final StreamPort<LogEntry> LOG = new StreamPort<>("log", LogEntry.class, Arity.MANY, "Tells.");

  private static final long PERIOD_NANOS = 1_000_000;

  @Override
  public Descriptor descriptor() {
    return new Descriptor("badrobot", "Bad robot", "A robot interface of the tests.", Plan.SCHEMA, List.of());
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    Plan plan = Plan.of(settings);
    plan.at("create");
    return new Instance(plan, context, settings.text("file"));
  }

  private record Instance(Plan plan, RficContext context, String file) implements Rfic {
    @Override
    public void start() {
      plan.at("start");
      context.offers().command(DRIVE, this::send);
      context.offers().call(SERVICES, invocation -> {
        plan.at("call");
        return new ServiceReply(DataRecord.of(VelocityCommand.ZERO));
      });
      Publication<LogEntry> log = context.offers().stream(LOG, wanted -> plan.at("demand"));
      context.link().report(new LinkState.Connected("bad"));
      if (plan.isAt("thread") || plan.isAt("publish")) {
        context.threads().newThread(() -> run(log)).start();
      }
    }

    private void run(Publication<LogEntry> log) {
      while (!Thread.currentThread().isInterrupted()) {
        plan.at("thread");
        if (plan.isAt("publish")) {
          log.publish(new LogEntry(Severity.INFO, "bad", "x".repeat(1000), ""), Optional.empty());
        } else {
          LockSupport.parkNanos(PERIOD_NANOS);
        }
      }
    }

    private CommandSink.Sent send(VelocityCommand command) {
      plan.at("send");
      if (!file.isEmpty()) {
        note(command);
      }
      return new CommandSink.Sent.Out();
    }

    private void note(VelocityCommand command) {
      try {
        Files.writeString(Path.of(file), System.nanoTime() + " " + command.linear().x() + "\n",
            StandardOpenOption.CREATE,
            StandardOpenOption.APPEND);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }

    @Override
    public void close() {
      plan.at("close");
    }
  }
}
