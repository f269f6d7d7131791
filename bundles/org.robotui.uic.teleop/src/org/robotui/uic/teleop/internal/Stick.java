package org.robotui.uic.teleop.internal;

/**
 * Where a stick is held.
 *
 * @param forward 1 is fully forward, -1 fully back
 * @param left 1 is fully to the left, -1 to the right
 */
record Stick(double forward, double left) {
  static final Stick REST = new Stick(0, 0);

  private static final double DEAD_ZONE = 0.05;

  /** The stick of a pointer, y downwards, as a share of the radius; kept on the disc, with rest in the middle. */
  static Stick ofPointer(double x, double y) {
    double length = Math.hypot(x, y);
    if (length < DEAD_ZONE) {
      return REST;
    }
    double share = length > 1 ? 1 / length : 1;
    return new Stick(-y * share, -x * share);
  }

  /** Adds what another key wants; opposite keys cancel, equal ones do not add up. */
  Stick with(Stick other) {
    return new Stick(Math.clamp(forward + other.forward, -1.0, 1.0), Math.clamp(left + other.left, -1.0, 1.0));
  }

  Stick times(double factor) {
    return new Stick(forward * factor, left * factor);
  }
}
