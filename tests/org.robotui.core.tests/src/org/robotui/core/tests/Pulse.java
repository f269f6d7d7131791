package org.robotui.core.tests;

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
import org.robotui.api.port.Input;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.sensor.Battery;

/**
 * A type of a healthy view: it counts the values that came and, where it is to, moves the robot as a joystick does.
 *
 * @param id the word in configurations
 * @param drives whether it moves the robot
 * @param values counts
 */
record Pulse(String id, boolean drives, AtomicInteger values) implements UicType {
  private static final double RATE_HZ = 50;
  private static final Duration VALID = Duration.ofMillis(400);
  private static final int ENOUGH = 20;

  Pulse(String id, boolean drives) {
    this(id, drives, new AtomicInteger());
  }

  /** Waits for twenty values from now on. */
  void awaitMore() {
    int before = values.get();
    Eventually.await(id + " gets values", () -> values.get() > before + ENOUGH, values::get);
  }

  @Override
  public Descriptor descriptor() {
    return new Descriptor(id, "Pulse", "A view of the tests.",
        Schema.EMPTY, drives ? List.of(FakeRobot.BATTERY, Wheels.DRIVE) : List.of(FakeRobot.BATTERY));
  }

  @Override
  public Surface surface() {
    return Surface.TEXT;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    Input<Battery> battery = context.input(FakeRobot.BATTERY);
    Runnable drive = drives ? driving(context.output(Wheels.DRIVE)) : () -> {};
    return new Uic() {
      @Override
      public boolean tick(long nowNanos) {
        drive.run();
        return battery.drain(envelope -> values.incrementAndGet()) > 0;
      }

      @Override
      public void close() {
        // It holds nothing.
      }
    };
  }

  private static Runnable driving(Output<VelocityCommand> output) {
    return () -> output.send(VelocityCommand.planar(1, 0), VALID);
  }
}
