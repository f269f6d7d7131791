package org.robotui.data.sensor;

import org.robotui.data.FrameId;
import org.robotui.data.internal.Check;

/**
 * The distance measured by one sonar or infrared sensor.
 *
 * @param frame frame of the sensor; it looks along x
 * @param kind how it measures
 * @param fieldOfView full opening angle of the cone, radians
 * @param rangeMin shortest measurable distance, metres
 * @param rangeMax longest measurable distance, metres
 * @param range the distance, metres; {@code +inf} no echo, {@code -inf} too close, NaN invalid
 */
public record RangeReading(
    FrameId frame, Kind kind, double fieldOfView, double rangeMin, double rangeMax, double range) {
  /** How a distance is measured. */
  public enum Kind {
    /** By sound. */
    ULTRASOUND,
    /** By infrared light. */
    INFRARED
  }

  /**
   * Checks the geometry.
   *
   * @param frame frame of the sensor
   * @param kind how it measures
   * @param fieldOfView radians
   * @param rangeMin metres
   * @param rangeMax metres
   * @param range metres
   */
  public RangeReading {
    Check.notNegative(fieldOfView, "fieldOfView");
    Check.notNegative(rangeMin, "rangeMin");
    Check.that(rangeMax >= rangeMin, "rangeMax", "must not be below rangeMin " + rangeMin + ", is " + rangeMax);
  }

  /**
   * Tells whether something was hit at a known distance.
   *
   * @return true where the range is within the limits and no more than 10^9 m
   */
  public boolean isEcho() {
    return range >= rangeMin && range <= rangeMax && range <= Check.FARTHEST;
  }
}
