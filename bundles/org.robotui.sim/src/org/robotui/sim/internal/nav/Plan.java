package org.robotui.sim.internal.nav;

import java.util.List;
import org.robotui.sim.internal.world.Pose2;

/** What a planner answers. */
public sealed interface Plan {
  /**
   * A way.
   *
   * @param poses from the start to the goal, heading along the way, the last one as the goal asks
   */
  record Found(List<Pose2> poses) implements Plan {
    public Found {
      poses = List.copyOf(poses);
    }
  }

  /**
   * No way.
   *
   * @param reason for a user
   */
  record Impossible(String reason) implements Plan {}
}
