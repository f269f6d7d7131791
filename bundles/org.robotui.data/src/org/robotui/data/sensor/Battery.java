package org.robotui.data.sensor;

import org.robotui.data.Data;
import org.robotui.data.internal.Check;

/**
 * The state of a battery; NaN where a quantity is not measured.
 *
 * @param voltage volts
 * @param current amperes, negative when discharging
 * @param charge fraction of full, 0 to 1
 * @param status what it is doing
 */
public record Battery(double voltage, double current, double charge, Status status) implements Data {
  /** What a battery is doing. */
  public enum Status {
    /** Not known. */
    UNKNOWN,
    /** Being charged. */
    CHARGING,
    /** Driving the robot. */
    DISCHARGING,
    /** Connected but not charging. */
    NOT_CHARGING,
    /** Full. */
    FULL
  }

  /**
   * Checks the charge.
   *
   * @param voltage volts
   * @param current amperes
   * @param charge 0 to 1 or NaN
   * @param status what it is doing
   */
  public Battery {
    Check.that(Double.isNaN(charge) || charge >= 0 && charge <= 1, "charge", "must be 0 to 1, is " + charge);
  }
}
