package org.robotui.entity.odometry.internal.colored;

import org.robotui.data.FrameId;

/**
 * The places of a way, each with the value that was there. The arrays are not changed.
 *
 * @param frame in which they are
 * @param xyz x, y and z in turn, metres
 * @param values one for each place; NaN where it is not known
 */
public record WayPoints(FrameId frame, double[] xyz, double[] values) {
  /** How many places. */
  public int count() {
    return values.length;
  }
}
