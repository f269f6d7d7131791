package org.robotui.uic.teleop.internal;

/**
 * A speed of a base that cannot go sideways.
 *
 * @param forward metres per second
 * @param turn radians per second, positive to the left
 */
record Speed(double forward, double turn) {
  static final Speed ZERO = new Speed(0, 0);

  /** The speed on the way to a target after some seconds, each part as fast as its acceleration allows. */
  Speed toward(Speed target, Limits limits, double seconds) {
    return new Speed(step(forward, target.forward, limits.linearAcceleration() * seconds),
        step(turn, target.turn, limits.angularAcceleration() * seconds));
  }

  private static double step(double from, double to, double most) {
    return from + Math.clamp(to - from, -most, most);
  }
}
