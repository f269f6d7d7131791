package org.robotui.sim.internal.sensor;

/**
 * A part of the robot's rim that feels contact.
 *
 * @param name for a user
 * @param from bearing of its right end, radians counter-clockwise from the front
 * @param to bearing of its left end, more than {@code from}
 */
public record BumperSpec(String name, double from, double to) {
  public BumperSpec {
    if (!(from < to)) {
      throw new IllegalArgumentException("a bumper goes from right to left");
    }
  }

  public double middle() {
    return (from + to) / 2;
  }

  /** Along the rim of a body, metres. */
  public double length(double radius) {
    return (to - from) * radius;
  }
}
