package org.robotui.rtps.internal.wire;

import java.time.Duration;
import org.robotui.rtps.Qos;

/** Times as they are on the wire: seconds, and fractions of a second in units of 2^-32 s. */
public final class WireTime {

  /** No time. */
  public static final long NONE = Long.MIN_VALUE;

  private static final long SECOND = 1_000_000_000L;

  private static final long FRACTION = 0xffff_ffffL;

  private WireTime() {}

  /**
   * A point in time, in nanoseconds since 1970.
   *
   * @param seconds unsigned; all bits set for no time
   * @param fraction of a second
   * @return nanoseconds, or {@link #NONE}
   */
  public static long nanos(int seconds, int fraction) {
    if (seconds == -1) {
      return NONE;
    }
    return Integer.toUnsignedLong(seconds) * SECOND + nanosOfSecond(fraction);
  }

  /** Rounded to the nearest nanosecond, so that what {@link #fraction} made comes back as it was. */
  private static long nanosOfSecond(int fraction) {
    return Math.min(SECOND - 1, (Integer.toUnsignedLong(fraction) * SECOND + (1L << 31)) >>> 32);
  }

  /** The seconds of a point in time. */
  public static int seconds(long nanos) {
    return nanos == NONE ? -1 : (int) Math.floorDiv(nanos, SECOND);
  }

  /** The fraction of a second of a point in time. */
  public static int fraction(long nanos) {
    return nanos == NONE ? -1 : fractionOf(Math.floorMod(nanos, SECOND));
  }

  private static int fractionOf(long nanosOfSecond) {
    return (int) (((nanosOfSecond << 32) + SECOND / 2) / SECOND);
  }

  /**
   * How long something takes.
   *
   * @throws WireException if it is less than nothing
   */
  static Duration duration(int seconds, int fraction) throws WireException {
    if (seconds == Integer.MAX_VALUE) {
      return Qos.INFINITE;
    }
    if (seconds < 0) {
      throw new WireException("a duration of " + seconds + " s");
    }
    return Duration.ofSeconds(seconds, nanosOfSecond(fraction));
  }

  static int seconds(Duration time) {
    return Qos.infinite(time) ? Integer.MAX_VALUE : (int) time.getSeconds();
  }

  static int fraction(Duration time) {
    return Qos.infinite(time) ? (int) FRACTION : fractionOf(time.getNano());
  }
}
