package org.robotui.data.joint;

import java.util.List;
import org.robotui.data.Delivery;
import org.robotui.data.array.Doubles;
import org.robotui.data.internal.Check;

/**
 * How joints move, or shall move, over time.
 *
 * @param joints names, in the order of the numbers of the points
 * @param points in the order of time
 */
@Delivery(expires = false)
public record JointTrajectory(List<String> joints, List<Point> points) implements Trajectory {
  /**
   * What the joints do at a time.
   *
   * @param seconds since the start
   * @param positions radians or metres, one a joint or none
   * @param velocities per second, one a joint or none
   * @param accelerations per second squared, one a joint or none
   * @param efforts newton metres or newton, one a joint or none
   */
  public record Point(double seconds, Doubles positions, Doubles velocities, Doubles accelerations, Doubles efforts) {}

  /**
   * Copies the lists and checks that each point has a number a joint, or none.
   *
   * @param joints names
   * @param points in the order of time
   */
  public JointTrajectory {
    joints = List.copyOf(joints);
    points = List.copyOf(points);
    for (int i = 0; i < points.size(); i++) {
      Point point = points.get(i);
      Check.emptyOr(point.positions.size(), joints.size(), "points[" + i + "].positions");
      Check.emptyOr(point.velocities.size(), joints.size(), "points[" + i + "].velocities");
      Check.emptyOr(point.accelerations.size(), joints.size(), "points[" + i + "].accelerations");
      Check.emptyOr(point.efforts.size(), joints.size(), "points[" + i + "].efforts");
    }
  }
}
