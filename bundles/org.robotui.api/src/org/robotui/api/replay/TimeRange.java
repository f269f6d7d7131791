package org.robotui.api.replay;

/**
 * A range of times, both ends in it.
 *
 * @param start nanoseconds since 1970
 * @param end nanoseconds since 1970, not before the start
 */
public record TimeRange(long start, long end) {
  /**
   * As the components say.
   *
   * @param start nanoseconds since 1970
   * @param end nanoseconds since 1970
   * @throws IllegalArgumentException where the end is before the start
   */
  public TimeRange {
    if (end < start) {
      throw new IllegalArgumentException("a range of times from " + start + " to " + end);
    }
  }

  /**
   * The time in the range that is nearest to a time.
   *
   * @param time nanoseconds since 1970
   * @return the time itself where it is in the range
   */
  public long nearest(long time) {
    return Math.clamp(time, start, end);
  }

  /**
   * The smallest range that has both.
   *
   * @param other another range
   * @return from the earlier start to the later end
   */
  public TimeRange with(TimeRange other) {
    return new TimeRange(Math.min(start, other.start), Math.max(end, other.end));
  }

  /**
   * How long it is.
   *
   * @return in nanoseconds; the largest number where it is longer
   */
  public long length() {
    long length = end - start;
    return length < 0 ? Long.MAX_VALUE : length;
  }
}
