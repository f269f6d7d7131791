package org.robotui.sim.internal;

import org.robotui.sim.internal.robot.DriveLimits;
import org.robotui.sim.internal.robot.Speed;

/**
 * What can be changed while the robot runs.
 *
 * @param limits of the drive
 * @param style how it drives to goals
 * @param personWalks whether the person in the building walks
 */
public record Tuning(DriveLimits limits, Style style, boolean personWalks) {
  /** How much of its limits the robot uses on its way to a goal. */
  public enum Style {
    CAREFUL(0.4, "Keeps well below the limits"),
    NORMAL(0.8, "Leaves some room for commands"),
    BRISK(1.0, "Uses all that the limits allow");

    private final double share;
    private final String description;

    Style(double share, String description) {
      this.share = share;
      this.description = description;
    }

    public String description() {
      return description;
    }
  }

  public static Tuning of(DriveLimits limits) {
    return new Tuning(limits, Style.NORMAL, true);
  }

  /** The speeds not to be exceeded on the way to a goal. */
  public Speed cruise() {
    return new Speed(style.share * limits.linear(), 0.875 * style.share * limits.angular());
  }
}
