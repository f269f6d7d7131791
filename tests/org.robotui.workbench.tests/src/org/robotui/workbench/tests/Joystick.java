package org.robotui.workbench.tests;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.command.Output;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.data.command.VelocityCommand;

/**
 * A type without a surface that moves the robot again and again, as a joystick does.
 *
 * @param ticks counts
 */
record Joystick(AtomicInteger ticks) implements UicType {
  private static final double RATE_HZ = 50;
  private static final Duration VALID = Duration.ofMillis(400);

  Joystick() {
    this(new AtomicInteger());
  }

  @Override
  public Descriptor descriptor() {
    return new Descriptor("joystick", "Joystick", "A view of the tests.", Schema.EMPTY, List.of(Rover.DRIVE));
  }

  @Override
  public Surface surface() {
    return Surface.NONE;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    Output<VelocityCommand> output = context.output(Rover.DRIVE);
    return new Uic() {
      @Override
      public boolean tick(long nowNanos) {
        ticks.incrementAndGet();
        output.send(VelocityCommand.planar(1, 0), VALID);
        return false;
      }

      @Override
      public void close() {
        // It holds nothing.
      }
    };
  }
}
