package org.robotui.testkit;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.api.time.RobotClock;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;

/** A robot clock that shows the time of this machine and jumps when a test says so. */
public final class FakeClock implements RobotClock {
  private final AtomicLong epoch = new AtomicLong();

  /** Says that it has jumped back. */
  public void jump() {
    epoch.incrementAndGet();
  }

  @Override
  public Stamp now() {
    return new Stamp(System.currentTimeMillis() * 1_000_000L, ClockKind.WALL);
  }

  @Override
  public ClockKind kind() {
    return ClockKind.WALL;
  }

  @Override
  public Optional<Duration> offset() {
    return Optional.empty();
  }

  @Override
  public long epoch() {
    return epoch.get();
  }
}
