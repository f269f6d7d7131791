package org.robotui.data.sensor;

import org.robotui.data.internal.Check;
import org.robotui.geometry.RigidTransform;

/**
 * One bumper of a robot: a segment, or an arc, that feels contact.
 *
 * @param pose of its middle in the frame of its {@link Bumpers}: it feels along x and lies along y
 * @param length along it, metres; 0 where its robot does not tell where it is
 * @param radius of its bend, whose centre lies behind it, metres; 0 for a straight one
 * @param pressed whether something touches it
 */
public record Bumper(RigidTransform pose, double length, double radius, boolean pressed) {
  /**
   * Checks the geometry.
   *
   * @param pose of its middle
   * @param length metres
   * @param radius metres
   * @param pressed whether something touches it
   */
  public Bumper {
    Check.pose(pose, "pose");
    Check.within(length, 0, Check.FARTHEST, "length");
    Check.within(radius, 0, Check.FARTHEST, "radius");
  }
}
