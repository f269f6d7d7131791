package org.robotui.data.sensor;

import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;
import org.robotui.data.array.Floats;
import org.robotui.data.internal.Check;

/**
 * One sweep of a planar laser scanner.
 *
 * <p>Ranges follow REP-117: a finite number between the limits is an echo, {@code +inf} no echo within {@code rangeMax}
 * (the beam was free), {@code -inf} something too close to measure, NaN an invalid measurement. A finite value outside
 * the limits is to be read as no echo; {@link #isEcho} decides.
 *
 * @param frame frame of the scanner: beams lie in its x-y plane, angle 0 along x
 * @param angleMin angle of the first beam, radians
 * @param angleIncrement angle between beams, radians, negative for a clockwise scanner
 * @param rangeMin shortest measurable distance, metres
 * @param rangeMax longest measurable distance, metres
 * @param scanTime time between scans, seconds, 0 where unknown
 * @param ranges a distance per beam, metres
 * @param intensities a device dependent strength per beam, or none
 */
public record LaserScan(
    FrameId frame,
    double angleMin,
    double angleIncrement,
    double rangeMin,
    double rangeMax,
    double scanTime,
    Floats ranges,
    Floats intensities)
    implements Data, InFrame {
  /**
   * Checks the geometry.
   *
   * @param frame frame of the scanner
   * @param angleMin radians
   * @param angleIncrement radians
   * @param rangeMin metres
   * @param rangeMax metres
   * @param scanTime seconds
   * @param ranges metres
   * @param intensities none or one per range
   */
  public LaserScan {
    Check.finite(angleMin, "angleMin");
    Check.finite(angleIncrement, "angleIncrement");
    Check.notNegative(rangeMin, "rangeMin");
    Check.that(rangeMax >= rangeMin, "rangeMax", "must not be below rangeMin " + rangeMin + ", is " + rangeMax);
    Check.notNegative(scanTime, "scanTime");
    Check.emptyOr(intensities.size(), ranges.size(), "intensities");
  }

  /**
   * The direction of a beam.
   *
   * @param beam from 0
   * @return radians
   */
  public double angle(int beam) {
    return angleMin + beam * angleIncrement;
  }

  /**
   * Tells whether a beam hit something at a known distance.
   *
   * @param beam from 0
   * @return true where its range is within the limits and no more than 10^9 m
   */
  public boolean isEcho(int beam) {
    float range = ranges.get(beam);
    return range >= rangeMin && range <= rangeMax && range <= Check.FARTHEST;
  }
}
