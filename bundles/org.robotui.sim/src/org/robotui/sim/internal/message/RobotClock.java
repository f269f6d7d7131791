package org.robotui.sim.internal.message;

/** The time that stamps are made of, told by the simulation's thread. For any thread. */
public final class RobotClock {
  private volatile long nanos;

  public RobotClock(long nanos) {
    this.nanos = nanos;
  }

  void set(long now) {
    nanos = now;
  }

  public long nanos() {
    return nanos;
  }
}
