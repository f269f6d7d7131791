package org.robotui.sim.internal.nav;

import java.util.List;
import java.util.Optional;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/**
 * Drives straight to a place of odometry, as simple bases do: nothing is planned and nothing avoided. For one thread.
 */
public final class Homing {
  private final PathFollower follower;

  /**
   * @param goal in the odometry frame
   * @param most the speeds not to be exceeded
   */
  public Homing(Pose2 goal, Speed most) {
    follower = new PathFollower(List.of(goal), most);
  }

  /** The speed to go on with; empty when it has arrived. */
  public Optional<Speed> update(Pose2 odometry) {
    return follower.hasArrived(odometry) ? Optional.empty() : Optional.of(follower.follow(odometry));
  }
}
