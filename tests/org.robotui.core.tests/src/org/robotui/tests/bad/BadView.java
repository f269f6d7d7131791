package org.robotui.tests.bad;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.api.Descriptor;
import org.robotui.api.TextUic;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.data.command.VelocityCommand;

/**
 * The type of a view that misbehaves in {@code create}, {@code first_tick}, {@code tick} (each later one),
 * {@code task}, {@code lines} or {@code close}.
 */
final class BadView implements UicType {
  private static final CommandPort<VelocityCommand> DRIVE =
      new CommandPort<>("cmd_vel", VelocityCommand.class, Arity.MANY, "Drives.");
  private static final Duration LONG = Duration.ofMinutes(1);
  private static final double FASTEST_HZ = 1000;

  @Override
  public Descriptor descriptor() {
    return new Descriptor("badview", "Bad view", "A view of the tests.", Plan.SCHEMA, List.of(DRIVE));
  }

  @Override
  public Surface surface() {
    return Surface.TEXT;
  }

  @Override
  public double rateHz() {
    return FASTEST_HZ;
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    Plan plan = Plan.of(settings);
    plan.at("create");
    return new Instance(plan, context, new AtomicBoolean());
  }

  /** Always has something new. */
  private record Instance(Plan plan, UicContext context, AtomicBoolean ticked) implements TextUic {
    @Override
    public boolean tick(long nowNanos) {
      if (plan.drives()) {
        context.output(DRIVE).send(VelocityCommand.planar(1, 0), LONG);
      }
      if (plan.isAt("task")) {
        context.background().execute(() -> plan.at("task"));
      }
      plan.at(ticked.getAndSet(true) ? "tick" : "first_tick");
      return true;
    }

    @Override
    public List<String> lines(int columns, int rows) {
      plan.at("lines");
      return List.of("fine");
    }

    @Override
    public void close() {
      plan.at("close");
    }
  }
}
