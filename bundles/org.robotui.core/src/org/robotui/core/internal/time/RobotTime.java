package org.robotui.core.internal.time;

import java.util.OptionalLong;
import org.robotui.api.time.ClockSource;

/** What one robot interface knows of its robot's time. */
public final class RobotTime implements ClockSource, Ageing {
  /** Several publishers of simulated time are never quite in step; that is no jump. */
  private static final long JITTER_NANOS = 10_000_000L;

  private final NanoClock clock;
  private final WallClock wall;
  private final Runnable jumped;
  private final OffsetFilter filter = new OffsetFilter();
  private boolean simulated;
  private volatile boolean replayed;
  private final TimeTrack track = new TimeTrack();
  private long simulatedNanos;

  RobotTime(NanoClock clock, WallClock wall, Runnable jumped) {
    this.clock = clock;
    this.wall = wall;
    this.jumped = jumped;
  }

  @Override
  public void simulated(long nanos) {
    if (advance(nanos)) {
      jumped.run();
    }
  }

  @Override
  public void replayed(long nanos) {
    replayed = true;
    simulated(nanos);
  }

  @Override
  public void moved(long nanos) {
    replayed = true;
    move(nanos);
    jumped.run();
  }

  private synchronized void move(long nanos) {
    simulated = true;
    simulatedNanos = nanos;
    track.begin(clock.nanos(), nanos);
  }

  private synchronized boolean advance(long nanos) {
    boolean jump = simulated ? nanos < simulatedNanos - JITTER_NANOS : filter.minimum(clock.nanos()).isPresent();
    boolean on = simulated && !jump;
    simulatedNanos = on ? Math.max(simulatedNanos, nanos) : nanos;
    simulated = true;
    if (replayed) {
      keep(on);
    }
    return jump;
  }

  private void keep(boolean on) {
    if (on) {
      track.add(clock.nanos(), simulatedNanos);
    } else {
      track.begin(clock.nanos(), simulatedNanos);
    }
  }

  @Override
  public void live() {
    if (leaveSimulation()) {
      jumped.run();
    }
  }

  private synchronized boolean leaveSimulation() {
    boolean was = simulated;
    replayed = false;
    simulated = false;
    if (was) {
      filter.clear();
    }
    return was;
  }

  @Override
  public void observed(long stampNanos) {
    if (!isSimulated()) {
      filter.observe(clock.nanos(), wall.nanos() - stampNanos);
    }
  }

  @Override
  public long nanos() {
    return replayed ? simulatedNanos() : clock.nanos();
  }

  @Override
  public long at(long receivedNanos) {
    return replayed ? recorded(receivedNanos) : receivedNanos;
  }

  private synchronized long recorded(long moment) {
    return track.time(moment);
  }

  @Override
  public synchronized long received(long nanos) {
    return replayed ? track.moment(nanos) : clock.nanos();
  }

  boolean isReplayed() {
    return replayed;
  }

  void forgetOffset() {
    filter.clear();
  }

  synchronized boolean isSimulated() {
    return simulated;
  }

  synchronized long simulatedNanos() {
    return simulatedNanos;
  }

  /** How far the robot's clock is ahead of ours. */
  OptionalLong offsetNanos() {
    OptionalLong minimum = filter.minimum(clock.nanos());
    return minimum.isPresent() ? OptionalLong.of(-minimum.getAsLong()) : minimum;
  }
}
