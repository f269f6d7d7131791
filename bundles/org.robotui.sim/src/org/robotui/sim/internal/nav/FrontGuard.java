package org.robotui.sim.internal.nav;

import java.util.function.Supplier;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.World;

/** Measures the free way straight before the robot, as the laser sees it. */
public final class FrontGuard {
  private static final double REACH = 1.5;
  private static final int RAYS = 15;
  private static final double SPREAD = Math.toRadians(140);

  private final Supplier<World> world;
  private final double radius;
  private final double height;

  /**
   * @param radius of the robot, metres
   * @param height of the laser, metres
   */
  public FrontGuard(Supplier<World> world, double radius, double height) {
    this.world = world;
    this.radius = radius;
    this.height = height;
  }

  /** Metres that the body can go forward before it touches what the laser sees. */
  public double room(Pose2 robot) {
    double room = REACH;
    for (int i = 0; i < RAYS; i++) {
      double angle = -SPREAD / 2 + SPREAD * i / (RAYS - 1);
      double range = world.get().range(robot.x(), robot.y(), robot.yaw() + angle, height, REACH);
      double side = range * Math.sin(angle);
      if (range <= REACH && Math.abs(side) < radius) {
        room = Math.min(room, range * Math.cos(angle) - Math.sqrt(radius * radius - side * side));
      }
    }
    return room;
  }
}
