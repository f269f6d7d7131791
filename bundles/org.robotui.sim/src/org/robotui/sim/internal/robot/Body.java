package org.robotui.sim.internal.robot;

import java.util.function.Supplier;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.World;

/** The robot's body in the building: a round base that stops at whatever it meets. For one thread. */
public final class Body {
  public static final double RADIUS = 0.25;
  public static final double HEIGHT = 0.65;

  private final Supplier<World> world;
  private Pose2 pose;

  public Body(Supplier<World> world, Pose2 start) {
    this.world = world;
    pose = start;
  }

  public Pose2 pose() {
    return pose;
  }

  public void place(Pose2 at) {
    pose = at;
  }

  /**
   * Moves, unless something is in the way; then only the heading changes.
   *
   * @return whether the way was free
   */
  public boolean move(double distance, double turn) {
    Pose2 next = pose.advance(distance, turn);
    if (distance == 0 || world.get().isFree(next.x(), next.y(), RADIUS, HEIGHT)) {
      pose = next;
      return true;
    }
    pose = new Pose2(pose.x(), pose.y(), next.yaw());
    return false;
  }
}
