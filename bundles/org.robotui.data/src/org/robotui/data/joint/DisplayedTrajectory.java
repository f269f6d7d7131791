package org.robotui.data.joint;

import java.util.List;
import org.robotui.data.Delivery;

/**
 * What a planner shows before it is done: how a robot would move.
 *
 * @param model name of the robot's model, may be empty
 * @param start joints before it moves; empty where the planner does not say
 * @param parts one after the other
 */
@Delivery(expires = false)
public record DisplayedTrajectory(String model, List<JointState.Joint> start, List<JointTrajectory> parts)
    implements Trajectory {
  /**
   * Copies the lists.
   *
   * @param model name of the model
   * @param start joints before it moves
   * @param parts one after the other
   */
  public DisplayedTrajectory {
    start = List.copyOf(start);
    parts = List.copyOf(parts);
  }
}
