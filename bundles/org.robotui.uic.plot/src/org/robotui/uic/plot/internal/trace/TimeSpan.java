package org.robotui.uic.plot.internal.trace;

/**
 * A span of time, both ends included.
 *
 * @param from nanoseconds
 * @param to nanoseconds, not before {@code from}
 */
public record TimeSpan(long from, long to) {
  public static final long SECOND = 1_000_000_000L;

  private static final double FARTHEST = 8e18;
  private static final long SHORTEST = 1_000;
  private static final long LONGEST = 400L * 24 * 3600 * SECOND;

  public TimeSpan {
    if (to < from) {
      throw new IllegalArgumentException("a span ends at " + to + " before it begins at " + from);
    }
  }

  /** A span that ends at a time. */
  public static TimeSpan until(long end, double seconds) {
    return new TimeSpan(end - nanos(seconds), end);
  }

  public static long nanos(double seconds) {
    return Math.round(seconds * SECOND);
  }

  public long length() {
    return to - from;
  }

  public double seconds() {
    return length() / (double) SECOND;
  }

  public boolean contains(long time) {
    return time >= from && time <= to;
  }

  public TimeSpan union(TimeSpan other) {
    return new TimeSpan(Math.min(from, other.from), Math.max(to, other.to));
  }

  /** A little more at both ends, so that what lies there is seen. */
  public TimeSpan widened() {
    long more = Math.max(SHORTEST, length() / 50);
    return Math.abs((double) from) > FARTHEST || Math.abs((double) to) > FARTHEST ? this
        : new TimeSpan(from - more, to + more);
  }

  /** Earlier or later; not beyond the times that numbers can tell. */
  public TimeSpan moved(long nanos) {
    boolean beyond = Math.abs((double) from + nanos) > FARTHEST || Math.abs((double) to + nanos) > FARTHEST;
    return beyond ? this : new TimeSpan(from + nanos, to + nanos);
  }

  /** Scales the length by a factor and leaves one time where it is on the screen. */
  public TimeSpan zoomed(double factor, long fixed) {
    double most = Math.clamp(factor * length(), SHORTEST, LONGEST) / Math.max(1, length());
    long start = fixed - Math.round((fixed - from) * most);
    return new TimeSpan(start, Math.max(start + SHORTEST, fixed + Math.round((to - fixed) * most)));
  }
}
