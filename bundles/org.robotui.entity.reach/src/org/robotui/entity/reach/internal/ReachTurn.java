package org.robotui.entity.reach.internal;

import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** The line that a robot follows which keeps its speed. */
final class ReachTurn {

  /** Points of a line. */
  static final int POINTS = 33;

  private ReachTurn() {}

  /**
   * Computes the line in small steps.
   *
   * @param odometry the speed, in the robot's own frame
   * @param fixedFromRobot where the robot is
   * @param seconds how far ahead
   * @return x and y in turn, metres in the fixed frame
   */
  static double[] of(Odometry odometry, RigidTransform fixedFromRobot, double seconds) {
    double step = seconds / (POINTS - 1);
    double[] xy = new double[2 * POINTS];
    Vector3 place = Vector3.ZERO;
    for (int i = 0; i < POINTS; i++) {
      Vector3 fixed = fixedFromRobot.apply(place);
      xy[2 * i] = fixed.x();
      xy[2 * i + 1] = fixed.y();
      double heading = odometry.angular().z() * step * (i + 0.5);
      Vector3 speed = odometry.linear();
      place = place.plus(new Vector3(speed.x() * Math.cos(heading) - speed.y() * Math.sin(heading),
          speed.x() * Math.sin(heading) + speed.y() * Math.cos(heading), 0).times(step));
    }
    return xy;
  }
}
