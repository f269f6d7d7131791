package org.robotui.rfic.recording.internal.compare;

import java.util.Optional;

/**
 * A number over time.
 *
 * @param times they rise
 * @param values one for each
 */
record NumberSeries(long[] times, double[] values) {
  /** The number at a time, on the line between those before and after it. */
  Optional<Double> at(long time) {
    return SortedTimes.between(times, time, (place, part) -> part == 0 ? values[place]
        : values[place] + part * (values[place + 1] - values[place]));
  }
}
