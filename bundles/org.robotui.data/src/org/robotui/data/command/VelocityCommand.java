package org.robotui.data.command;

import org.robotui.data.Delivery;
import org.robotui.data.Late;
import org.robotui.data.geometry.Twist;
import org.robotui.data.internal.Check;
import org.robotui.geometry.Vector3;

/**
 * A velocity that a mobile base shall keep, in its own frame.
 *
 * @param linear metres per second
 * @param angular radians per second
 */
@Delivery(late = Late.NONE)
public record VelocityCommand(Vector3 linear, Vector3 angular) implements Twist, Motion<VelocityCommand> {
  /** Stand still. */
  public static final VelocityCommand ZERO = new VelocityCommand(Vector3.ZERO, Vector3.ZERO);

  /**
   * Checks that all numbers are finite.
   *
   * @param linear metres per second
   * @param angular radians per second
   */
  public VelocityCommand {
    Check.that(linear.isFinite(), "linear", "must be finite, is " + linear);
    Check.that(angular.isFinite(), "angular", "must be finite, is " + angular);
  }

  /**
   * Forward and turning speed of a base that cannot go sideways.
   *
   * @param forward metres per second, negative is backward
   * @param turn radians per second, positive is to the left
   * @return the command
   */
  public static VelocityCommand planar(double forward, double turn) {
    return new VelocityCommand(new Vector3(forward, 0, 0), new Vector3(0, 0, turn));
  }

  @Override
  public VelocityCommand stopped() {
    return ZERO;
  }

  @Override
  public VelocityCommand within(MotionLimits limits) {
    double factor = Math.min(share(linear.norm(), limits.linear()), share(angular.norm(), limits.angular()));
    return factor < 1 ? new VelocityCommand(linear.times(factor), angular.times(factor)) : this;
  }

  private static double share(double value, double limit) {
    return value > limit ? limit / value : 1;
  }
}
