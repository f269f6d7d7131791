package org.robotui.core.internal.support;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.port.Port;
import org.robotui.api.show.Showing;

/** A type of view that does what a test tells it. */
public class FakeView implements UicType {
  public final List<UicContext> contexts = new CopyOnWriteArrayList<>();
  public final AtomicInteger ticks = new AtomicInteger();
  public final AtomicInteger closed = new AtomicInteger();
  private final String id;
  private final List<Port> ports;
  private volatile List<Showing> showings = List.of();
  private volatile Surface surface = Surface.WINDOW;
  private volatile Predicate<UicContext> onTick = context -> false;

  /** A type with an id and ports. */
  public FakeView(String id, Port... ports) {
    this.id = id;
    this.ports = List.of(ports);
  }

  public FakeView on(Surface where) {
    surface = where;
    return this;
  }

  public FakeView shows(Showing... all) {
    showings = List.of(all);
    return this;
  }

  @Override
  public List<Showing> showings() {
    return showings;
  }

  public FakeView onTick(Predicate<UicContext> action) {
    onTick = action;
    return this;
  }

  /** What the newest instance was given. */
  public UicContext context() {
    Await.until("an instance of " + id + " is there", () -> !contexts.isEmpty());
    return contexts.getLast();
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    contexts.add(context);
    return new Uic() {
      @Override
      public boolean tick(long nowNanos) {
        ticks.incrementAndGet();
        return onTick.test(context);
      }

      @Override
      public Optional<Object> retain() {
        return Optional.of(contexts.size());
      }

      @Override
      public void close() {
        closed.incrementAndGet();
      }
    };
  }

  @Override
  public Surface surface() {
    return surface;
  }

  @Override
  public double rateHz() {
    return 100;
  }

  @Override
  public Descriptor descriptor() {
    return new Descriptor(id, "Fake view", "",
        Schema.of(Setting.of("follow", new ValueType.Flag(), false, ""),
            Setting.of("zoom", new ValueType.Num(1, 100, ""), 10.0, ""),
            Setting.optional("left", new ValueType.Num(0, 100, ""), "").asState()),
        ports);
  }
}
