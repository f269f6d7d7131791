package org.robotui.data.internal;

import java.util.List;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** Validation at construction: the message names the component and what is wrong with it. */
public final class Check {
  /**
   * The greatest coordinate that a robot can mean, metres: farther than the moon, and still exact to a thousandth of a
   * millimetre.
   */
  public static final double FARTHEST = 1e9;

  private static final double UNIT_TOLERANCE = 0.01;

  private Check() {}

  public static void that(boolean holds, String component, String message) {
    if (!holds) {
      throw new IllegalArgumentException(component + ": " + message);
    }
  }

  public static void finite(double value, String component) {
    that(Double.isFinite(value), component, "must be finite, is " + value);
  }

  public static void notNegative(double value, String component) {
    that(value >= 0, component, "must not be negative or NaN, is " + value);
  }

  public static void within(double value, double least, double most, String component) {
    that(value >= least && value <= most, component, "must be from " + least + " to " + most + ", is " + value);
  }

  public static void place(Vector3 place, String component) {
    if (!isNear(place)) {
      that(false, component,
          "must be finite and within " + FARTHEST + " m, is " + place.x() + ", " + place.y() + ", " + place.z());
    }
  }

  public static void pose(RigidTransform pose, String component) {
    if (!isNear(pose.translation())) { // names and sentences are made for what is wrong only
      place(pose.translation(), component + ".position");
    }
    double length = pose.rotation().norm();
    if (!isUnit(length)) {
      that(false, component + ".orientation", "must be a quaternion of length 1, has length " + length);
    }
  }

  public static void poses(List<RigidTransform> poses, String component) {
    for (int i = 0; i < poses.size(); i++) {
      RigidTransform pose = poses.get(i);
      if (!isNear(pose.translation()) || !isUnit(pose.rotation().norm())) {
        pose(pose, component + "[" + i + "]");
      }
    }
  }

  private static boolean isNear(Vector3 place) {
    return Math.abs(place.x()) <= FARTHEST && Math.abs(place.y()) <= FARTHEST && Math.abs(place.z()) <= FARTHEST;
  }

  private static boolean isUnit(double length) {
    return Math.abs(length - 1) <= UNIT_TOLERANCE;
  }

  public static void sizeIs(int size, int expected, String component) {
    that(size == expected, component, "must have " + expected + " values, has " + size);
  }

  public static void emptyOr(int size, int expected, String component) {
    that(size == 0 || size == expected, component, "must have none or " + expected + " values, has " + size);
  }
}
