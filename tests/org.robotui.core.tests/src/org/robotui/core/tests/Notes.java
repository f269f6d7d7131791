package org.robotui.core.tests;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.port.Input;
import org.robotui.data.sensor.Battery;

/**
 * A type of view that counts what it gets.
 *
 * @param contexts what all instances ever made were given, in order
 * @param received counts the values that came
 * @param closed counts the instances that have ended
 */
record Notes(List<UicContext> contexts, AtomicInteger received, AtomicInteger closed) implements UicType {
  static final String ZOOM = "zoom";

  private static final double RATE_HZ = 50;

  Notes() {
    this(new CopyOnWriteArrayList<>(), new AtomicInteger(), new AtomicInteger());
  }

  /** Waits until values come again. */
  void awaitMore() {
    int before = received.get();
    Eventually.await("values come", () -> received.get() > before + 3, received::get);
  }

  /** The zoom of the newest instance. */
  double zoom() {
    return contexts.getLast().settings().current().number(ZOOM);
  }

  @Override
  public Descriptor descriptor() {
    return new Descriptor("notes", "Notes", "A view of the tests.",
        Schema.of(Setting.of(ZOOM, new ValueType.Num(1, 100, ""), 10.0, "How near.")), List.of(FakeRobot.BATTERY));
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
    contexts.add(context);
    Input<Battery> battery = context.input(FakeRobot.BATTERY);
    return new Uic() {
      @Override
      public boolean tick(long nowNanos) {
        return battery.drain(envelope -> received.incrementAndGet()) > 0;
      }

      @Override
      public void close() {
        closed.incrementAndGet();
      }
    };
  }
}
