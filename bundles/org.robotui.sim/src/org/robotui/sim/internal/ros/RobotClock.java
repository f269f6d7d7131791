package org.robotui.sim.internal.ros;

/** The time that stamps are made of, told by the simulation's thread. For any thread. */
final class RobotClock {
  private volatile long nanos;

  RobotClock(long nanos) {
    this.nanos = nanos;
  }

  void set(long now) {
    nanos = now;
  }

  long nanos() {
    return nanos;
  }
}
