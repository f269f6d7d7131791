package org.robotui.workbench.internal.timeline;

import org.robotui.api.replay.TimeRange;

/**
 * The times at which pictures of a part of the recordings are taken.
 *
 * @param range what is shown
 * @param rate pictures for each second of it
 */
record PictureSteps(TimeRange range, double rate) {
  private static final double NANOS = 1e9;

  int count() {
    return (int) Math.min(Integer.MAX_VALUE, Math.round(Math.floor(range.length() / NANOS * rate)) + 1);
  }

  long time(int picture) {
    return Math.min(range.end(), range.start() + Math.round(picture * NANOS / rate));
  }
}
