package org.robotui.ros.internal.node;

import java.time.Clock;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import org.robotui.ros.GraphName;
import org.robotui.ros.JumpListener;
import org.robotui.ros.NodeClock;
import org.robotui.ros.Subscriber;
import org.robotui.ros.XmlRpcValue;

/** Wall time, or the time of /clock while /use_sim_time is true. */
final class RosClock implements NodeClock {

  private final Clock wall = Clock.systemUTC();
  private final List<JumpListener> listeners = new CopyOnWriteArrayList<>();
  private final Supplier<Subscriber> subscribe;
  private Optional<Subscriber> source = Optional.empty();
  private volatile boolean simulated;
  private volatile long simulatedNanos;

  /** The supplier subscribes {@link #tick} to /clock. */
  RosClock(Supplier<Subscriber> subscribe) {
    this.subscribe = subscribe;
  }

  /** Follows the parameter /use_sim_time. */
  synchronized void useSimTime(GraphName key, Optional<XmlRpcValue> value) {
    boolean wanted = value.equals(Optional.of(XmlRpcValue.of(true)));
    if (wanted && source.isEmpty()) {
      simulatedNanos = 0;
      simulated = true;
      source = Optional.of(subscribe.get());
    } else if (!wanted && source.isPresent()) {
      simulated = false;
      source.get().close();
      source = Optional.empty();
    }
  }

  void tick(long nanos) {
    long before = simulatedNanos;
    simulatedNanos = nanos;
    if (nanos < before) {
      listeners.forEach(listener -> listener.onJumpBack(before, nanos));
    }
  }

  @Override
  public long nowNanos() {
    if (simulated) {
      return simulatedNanos;
    }
    Instant now = wall.instant();
    return now.getEpochSecond() * 1_000_000_000L + now.getNano();
  }

  @Override
  public boolean isSimulated() {
    return simulated;
  }

  @Override
  public AutoCloseable onJumpBack(JumpListener listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }
}
