package org.robotui.ros2.internal.link;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import org.robotui.ros2.Ros2Clock;
import org.robotui.ros2.Ros2Listener;
import org.robotui.ros2.Ros2Subscriber;

/** A node's time. */
public final class ClockLink implements Ros2Clock {

  private static final long NANOS = 1_000_000_000L;

  private final InstantSource wall;
  private final Function<Ros2Listener<Long>, Ros2Subscriber> subscribe;
  private final List<Ros2JumpListener> listeners = new CopyOnWriteArrayList<>();
  private Optional<Ros2Subscriber> subscriber = Optional.empty();
  private volatile boolean simulated;
  private volatile long last;

  /**
   * Wall time until told otherwise.
   *
   * @param wall the time of this machine
   * @param subscribe subscribes to simulated time, in nanoseconds
   */
  public ClockLink(InstantSource wall, Function<Ros2Listener<Long>, Ros2Subscriber> subscribe) {
    this.wall = wall;
    this.subscribe = subscribe;
  }

  @Override
  public long nowNanos() {
    if (simulated) {
      return last;
    }
    Instant now = wall.instant();
    return now.getEpochSecond() * NANOS + now.getNano();
  }

  @Override
  public boolean isSimulated() {
    return simulated;
  }

  @Override
  public synchronized void simulated(boolean now) {
    if (now == simulated) {
      return;
    }
    last = 0;
    simulated = now;
    subscriber.ifPresent(Ros2Subscriber::close);
    subscriber = now ? Optional.of(subscribe.apply((time, from) -> take(time))) : Optional.empty();
  }

  private void take(long now) {
    long before = last;
    last = now;
    if (now < before) {
      listeners.forEach(each -> each.onJumpBack(before, now));
    }
  }

  @Override
  public AutoCloseable onJumpBack(Ros2JumpListener listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }
}
