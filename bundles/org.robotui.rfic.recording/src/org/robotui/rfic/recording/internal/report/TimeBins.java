package org.robotui.rfic.recording.internal.report;

import org.robotui.api.replay.TimeRange;

/**
 * A range of time in equal parts, as a figure has columns.
 *
 * @param range all of it
 * @param count how many parts
 */
record TimeBins(TimeRange range, int count) {
  /** In which part a time lies; times outside lie in the first or the last one. */
  int of(long time) {
    double share = (double) (range.nearest(time) - range.start()) / Math.max(1, range.length());
    return Math.min(count - 1, (int) (share * count));
  }
}
