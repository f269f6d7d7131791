package org.robotui.sim.internal.robot;

import java.util.function.Supplier;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.World;

/** The robot's body in the building: a round base that stops at whatever it meets. For one thread. */
public final class Body {
  private final Supplier<World> world;
  private final double radius;
  private final double height;
  private Pose2 pose;

  /**
   * @param radius metres
   * @param height metres
   */
  public Body(Supplier<World> world, Pose2 start, double radius, double height) {
    this.world = world;
    this.radius = radius;
    this.height = height;
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
    if (distance == 0 || world.get().isFree(next.x(), next.y(), radius, height)) {
      pose = next;
      return true;
    }
    pose = new Pose2(pose.x(), pose.y(), next.yaw());
    return false;
  }
}
