package org.robotui.sim.internal.message;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.robotui.sim.internal.robot.DriveLimits;

/**
 * A limit of the drive that can be changed while the robot runs, as both generations of ROS show it.
 *
 * @param name of its parameter
 * @param description for a user
 * @param lowest what it may be
 * @param highest what it may be
 * @param value takes it out of the limits
 */
public record DriveLimit(String name, String description, double lowest, double highest,
    ToDoubleFunction<DriveLimits> value) {
  /** The name of the parameter for {@link org.robotui.sim.internal.Tuning.Style}. */
  public static final String STYLE = "driving_style";
  public static final String STYLE_DESCRIPTION = "How it drives to goals";
  /** The name of the parameter that says whether the person in the building walks. */
  public static final String WALKS = "person_walks";
  public static final String WALKS_DESCRIPTION = "Whether the person in the building walks";

  /** In the order of the components of {@link DriveLimits}. */
  public static final List<DriveLimit> ALL = List.of(
      new DriveLimit("max_linear_speed", "Metres per second", 0.05, 1.5, DriveLimits::linear),
      new DriveLimit("max_angular_speed", "Radians per second", 0.1, 4, DriveLimits::angular),
      new DriveLimit("max_linear_acceleration", "Metres per second squared; it brakes twice as hard", 0.1, 3,
          DriveLimits::linearAcceleration),
      new DriveLimit("max_angular_acceleration", "Radians per second squared; it brakes twice as hard", 0.5, 12,
          DriveLimits::angularAcceleration));

  /** The limits of which each is given. */
  public static DriveLimits limits(ToDoubleFunction<DriveLimit> given) {
    double[] values = ALL.stream().mapToDouble(given).toArray();
    return new DriveLimits(values[0], values[1], values[2], values[3]);
  }

  public double of(DriveLimits limits) {
    return value.applyAsDouble(limits);
  }
}
