package org.robotui.recording;

/**
 * A range of times, both ends in it.
 *
 * @param start nanoseconds since 1970
 * @param end nanoseconds since 1970, not before the start
 */
public record RecordingInterval(long start, long end) {

  /** All times. */
  public static final RecordingInterval ALWAYS = new RecordingInterval(Long.MIN_VALUE, Long.MAX_VALUE);

  /** As the components say. */
  public RecordingInterval {
    if (end < start) {
      throw new IllegalArgumentException("an interval from " + start + " to " + end);
    }
  }

  /**
   * From a time on.
   *
   * @param start nanoseconds since 1970
   * @return without an end
   */
  public static RecordingInterval from(long start) {
    return new RecordingInterval(start, Long.MAX_VALUE);
  }

  /**
   * Whether a time is in it.
   *
   * @param time nanoseconds since 1970
   * @return true at both ends too
   */
  public boolean contains(long time) {
    return start <= time && time <= end;
  }
}
