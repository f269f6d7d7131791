package org.robotui.uic.plot.internal.model;

import org.robotui.api.replay.RecordedValue;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * Places the values of one recorded stream on the timeline: by their stamps, or by when they were recorded. Stamps of
 * another clock than that of the recording, or of one that was set meanwhile, go on from where they are found. One
 * thread.
 */
final class RecordedClock {
  private static final double TRUSTED = 10.0 * TimeSpan.SECOND;

  private final boolean byStamp;
  private final long offset;
  private long shift;

  /** Given also what is to be added to times of the recording. */
  RecordedClock(boolean byStamp, long offset) {
    this.byStamp = byStamp;
    this.offset = offset;
  }

  /** When a value was true. */
  long timeOf(RecordedValue value) {
    if (!byStamp || value.stamp().isEmpty()) {
      return value.time() + offset;
    }
    long stamp = value.stamp().get().nanos();
    if (Math.abs((double) value.time() - (stamp + shift)) > TRUSTED) {
      shift = value.time() - stamp;
    }
    return stamp + shift + offset;
  }
}
