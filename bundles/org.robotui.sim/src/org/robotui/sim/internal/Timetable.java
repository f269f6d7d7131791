package org.robotui.sim.internal;

/**
 * When each step of a simulation is due: at a fixed rate on an absolute grid, so that lateness of one step does not
 * delay the next. Times are nanoseconds of one monotonic clock. For one thread.
 */
public final class Timetable {
  private static final long GIVE_UP = 500_000_000L;

  private final double stepNanos;
  private long start;
  private long steps;

  /** @param factor how many times faster than the clock the simulation runs */
  public Timetable(long now, double factor) {
    if (!(factor > 0) || Double.isInfinite(factor)) {
      throw new IllegalArgumentException("a speed factor must be positive, not " + factor);
    }
    start = now;
    stepNanos = Simulation.STEP * 1e9 / factor;
  }

  /** When the next step is due. */
  public long nextDue() {
    return start + Math.round((steps + 1) * stepNanos);
  }

  /**
   * Notes that a step is made now. After a long sleep of the machine the missed steps are left out, not made up for.
   */
  public void stepMade(long now) {
    long late = now - nextDue();
    if (late > GIVE_UP) {
      start += late;
    }
    steps++;
  }
}
