package org.robotui.message;

/** ROS times and durations as nanoseconds in a {@code long}, which holds every value ROS can send. */
public final class Stamps {

  private static final long NANOS = 1_000_000_000L;

  private Stamps() {}

  /**
   * Joins seconds and nanoseconds of a ROS time.
   *
   * @param secs unsigned seconds
   * @param nsecs unsigned nanoseconds
   * @return nanoseconds since the epoch of the sender's clock
   */
  public static long time(int secs, int nsecs) {
    return Integer.toUnsignedLong(secs) * NANOS + Integer.toUnsignedLong(nsecs);
  }

  /**
   * Joins seconds and nanoseconds of a ROS duration.
   *
   * @param secs signed seconds
   * @param nsecs signed nanoseconds
   * @return nanoseconds
   */
  public static long duration(int secs, int nsecs) {
    return secs * NANOS + nsecs;
  }

  /**
   * Joins seconds and nanoseconds of a time or duration of ROS 2.
   *
   * @param sec signed seconds
   * @param nanosec unsigned nanoseconds
   * @return nanoseconds
   */
  public static long signed(int sec, int nanosec) {
    return sec * NANOS + Integer.toUnsignedLong(nanosec);
  }

  /**
   * The seconds field of a ROS time or duration.
   *
   * @param nanos nanoseconds
   * @return whole seconds, rounded down; the bits of an unsigned number for times
   */
  public static int secs(long nanos) {
    return (int) Math.floorDiv(nanos, NANOS);
  }

  /**
   * The nanoseconds field of a ROS time or duration.
   *
   * @param nanos nanoseconds
   * @return 0 to 999999999
   */
  public static int nsecs(long nanos) {
    return (int) Math.floorMod(nanos, NANOS);
  }

  /**
   * Appends a ROS time or duration.
   *
   * @param nanos nanoseconds
   * @param out where the eight bytes go
   */
  public static void write(long nanos, MessageWriter out) {
    out.time(secs(nanos), nsecs(nanos));
  }
}
