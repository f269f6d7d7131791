package org.robotui.core.internal.time;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.api.time.ClockSource;
import org.robotui.api.time.RobotClock;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;

/**
 * The clock of one RUIC: the simulated time of its first robot interface that has one, else this machine's time moved
 * by the offset of the first that is known, else this machine's time.
 */
public final class RuicClock implements RobotClock {
  private final NanoClock clock;
  private final WallClock wall;
  private final Runnable jumped;
  private final AtomicLong epoch = new AtomicLong();
  private final Map<String, RobotTime> times = new LinkedHashMap<>();
  /** Of those above; views ask for ages of many values at each tick. */
  private volatile List<RobotTime> all = List.of();

  /**
   * A clock without sources.
   *
   * @param clock monotonic
   * @param wall this machine's
   * @param jumped is told that the time has jumped back, on the thread that reported it
   */
  public RuicClock(NanoClock clock, WallClock wall, Runnable jumped) {
    this.clock = clock;
    this.wall = wall;
    this.jumped = jumped;
  }

  /** The source of a robot interface; a new one in place of that of an earlier instance. */
  public synchronized RobotTime source(String component) {
    RobotTime time = new RobotTime(clock, wall, this::jump);
    times.put(component, time);
    all = List.copyOf(times.values());
    return time;
  }

  /** A robot interface has ended: its time counts no more. */
  public synchronized void forget(ClockSource source) {
    times.values().removeIf(t -> t == source);
    all = List.copyOf(times.values());
  }

  /** What was known of the time is void: consumers get a reset. */
  public void reset() {
    epoch.incrementAndGet();
  }

  /** The stamps of a robot interface jumped back: what was learnt of its robot's clock is void as well. */
  public void jumpedBack(ClockSource source) {
    all.stream().filter(t -> t == source).forEach(RobotTime::forgetOffset);
    jump();
  }

  /** The user says that what was before counts no more. */
  public void forgetPast() {
    all.forEach(RobotTime::forgetOffset);
    jump();
  }

  private void jump() {
    epoch.incrementAndGet();
    jumped.run();
  }

  @Override
  public Stamp now() {
    Optional<RobotTime> simulated = simulated();
    if (simulated.isPresent()) {
      return new Stamp(simulated.get().simulatedNanos(), ClockKind.SIMULATED);
    }
    return offset()
        .map(ahead -> new Stamp(wall.nanos() + ahead.toNanos(), ClockKind.ROBOT))
        .orElseGet(() -> new Stamp(wall.nanos(), ClockKind.WALL));
  }

  @Override
  public ClockKind kind() {
    return now().clock();
  }

  @Override
  public Optional<Duration> offset() {
    return all.stream()
        .map(RobotTime::offsetNanos)
        .filter(o -> o.isPresent())
        .findFirst()
        .map(o -> Duration.ofNanos(o.getAsLong()));
  }

  @Override
  public long epoch() {
    return epoch.get();
  }

  /** All recordings are played on one time. */
  @Override
  public long agingNanos(long nanos) {
    return all.stream().filter(RobotTime::isReplayed).findFirst().map(time -> time.at(nanos)).orElse(nanos);
  }

  private Optional<RobotTime> simulated() {
    return all.stream().filter(RobotTime::isSimulated).findFirst();
  }
}
