package org.robotui.uic.jointcontrol.internal.model;

import java.util.OptionalDouble;

/**
 * Where a joint is driven. Immutable.
 *
 * @param goal where the user wants it, radians or metres
 * @param target what is sent, on its way to the goal
 * @param stiffness what the user wants, where that was changed
 * @param damping what the user wants, where that was changed
 */
public record Aim(double goal, double target, OptionalDouble stiffness, OptionalDouble damping) {
  /** Begins where the joint is, so that its reference does not jump. */
  public static Aim from(double measured) {
    return new Aim(measured, measured, OptionalDouble.empty(), OptionalDouble.empty());
  }

  /** With another goal. */
  public Aim toward(double position) {
    return new Aim(position, target, stiffness, damping);
  }

  /** Stays where the target is now. */
  public Aim halted() {
    return toward(target);
  }

  /** One step on the way. */
  public Aim step(double farthest) {
    return new Aim(goal, target + Math.clamp(goal - target, -farthest, farthest), stiffness, damping);
  }

  /** With another stiffness. */
  public Aim stiff(double value) {
    return new Aim(goal, target, OptionalDouble.of(value), damping);
  }

  /** With another damping. */
  public Aim damped(double value) {
    return new Aim(goal, target, stiffness, OptionalDouble.of(value));
  }

  /** Whether the target is still on its way. */
  public boolean isMoving() {
    return goal != target;
  }
}
