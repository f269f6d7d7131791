package org.robotui.rfic.recording.internal.compare;

import java.util.Arrays;
import java.util.Optional;

/** Finds places among times that rise. */
final class SortedTimes {
  private SortedTimes() {}

  /**
   * Makes a value of two others.
   *
   * @param <V> the value
   */
  interface Between<V> {
    /** Of the one at a place and, for a part above 0, the one behind it. */
    V of(int place, double part);
  }

  /** A value at a time; empty before the first time and after the last one. */
  static <V> Optional<V> between(long[] times, long time, Between<V> values) {
    int found = Arrays.binarySearch(times, time);
    if (found >= 0) {
      return Optional.of(values.of(found, 0));
    }
    int after = -found - 1;
    if (after == 0 || after == times.length) {
      return Optional.empty();
    }
    double part = (double) (time - times[after - 1]) / (times[after] - times[after - 1]);
    return Optional.of(values.of(after - 1, part));
  }

  /** The place of the time that is nearest; of two, the earlier one. */
  static int nearest(long[] times, long time) {
    int found = Arrays.binarySearch(times, time);
    if (found >= 0) {
      return found;
    }
    int after = -found - 1;
    if (after == 0) {
      return 0;
    }
    return after == times.length || time - times[after - 1] <= times[after] - time ? after - 1 : after;
  }
}
