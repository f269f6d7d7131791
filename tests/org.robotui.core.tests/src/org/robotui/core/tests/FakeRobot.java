package org.robotui.core.tests;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.sensor.Battery;

/**
 * A type of robot interface whose instances tell of a battery, from a thread of their own.
 *
 * @param id the word in configurations
 * @param peers the setting {@code peer} of all instances ever made, in order
 * @param closed counts the instances that have ended
 */
record FakeRobot(String id, List<String> peers, AtomicInteger closed) implements RficType {
  static final StreamPort<Battery> BATTERY = new StreamPort<>("battery", Battery.class, Arity.MANY, "The battery.");

  private static final long PERIOD_NANOS = 10_000_000;
  private static final long END_MILLIS = 1000;

  FakeRobot(String id) {
    this(id, new CopyOnWriteArrayList<>(), new AtomicInteger());
  }

  @Override
  public Descriptor descriptor() {
    return new Descriptor(id, "Fake robot", "A robot of the tests.",
        Schema.of(Setting.of("peer", new ValueType.Text(), "nowhere", "Whom it calls.")), List.of());
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    peers.add(settings.text("peer"));
    return new Instance(context);
  }

  private final class Instance implements Rfic {
    private final RficContext context;
    private final Thread thread;

    Instance(RficContext context) {
      this.context = context;
      this.thread = context.threads().newThread(this::run);
    }

    @Override
    public void start() {
      thread.start();
    }

    private void run() {
      context.link().report(new LinkState.Connected(id));
      try (Publication<Battery> battery = context.offers().stream(BATTERY, Demand.IGNORED)) {
        while (!Thread.currentThread().isInterrupted()) {
          battery.publish(new Battery(24, -1, 0.5, Battery.Status.DISCHARGING), Optional.empty());
          LockSupport.parkNanos(PERIOD_NANOS);
        }
      }
    }

    @Override
    public void close() {
      thread.interrupt();
      try {
        thread.join(END_MILLIS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      closed.incrementAndGet();
    }
  }
}
