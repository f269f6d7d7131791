package org.robotui.core.internal.support;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.port.Port;

/** A type of robot interface that does what a test tells it. */
public final class FakeRobot implements RficType {
  public final List<RficContext> contexts = new CopyOnWriteArrayList<>();
  public final AtomicInteger closed = new AtomicInteger();
  private final String id;
  private volatile List<Port> ports = List.of();
  private volatile Consumer<RficContext> onCreate = context -> {};
  private volatile Consumer<RficContext> onStart = context -> {};
  private volatile Runnable onClose = () -> {};

  /** A type with an id. */
  public FakeRobot(String id) {
    this.id = id;
  }

  /** Ports that it always has. */
  public FakeRobot ports(Port... always) {
    ports = List.of(always);
    return this;
  }

  public FakeRobot onCreate(Consumer<RficContext> action) {
    onCreate = action;
    return this;
  }

  public FakeRobot onStart(Consumer<RficContext> action) {
    onStart = action;
    return this;
  }

  public FakeRobot onClose(Runnable action) {
    onClose = action;
    return this;
  }

  /** What the newest instance was given. */
  public RficContext context() {
    Await.until("an instance of " + id + " is there", () -> !contexts.isEmpty());
    return contexts.getLast();
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    onCreate.accept(context);
    contexts.add(context);
    return new Rfic() {
      @Override
      public void start() {
        onStart.accept(context);
      }

      @Override
      public void close() {
        closed.incrementAndGet();
        onClose.run();
      }
    };
  }

  @Override
  public Descriptor descriptor() {
    return new Descriptor(id, "Fake robot", "", Schema.of(Setting.of("peer", new ValueType.Text(), "nowhere", "")),
        ports);
  }
}
