package org.robotui.sim.internal.sensor;

import java.util.List;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.World;

/** Feels what stands at the rim of the body. */
public final class BumperRing {
  private static final double REACH = 0.015;
  private static final double STEP = Math.toRadians(2);

  private final List<BumperSpec> bumpers;
  private final double radius;
  private final double height;

  /**
   * @param radius of the body, metres
   * @param height of the body, metres
   */
  public BumperRing(List<BumperSpec> bumpers, double radius, double height) {
    this.bumpers = List.copyOf(bumpers);
    this.radius = radius;
    this.height = height;
  }

  /** Nothing is felt. */
  public List<Boolean> free() {
    return bumpers.stream().map(bumper -> false).toList();
  }

  /** Whether each bumper touches something. */
  public List<Boolean> touch(World world, Pose2 robot) {
    return bumpers.stream().map(bumper -> touches(bumper, world, robot)).toList();
  }

  private boolean touches(BumperSpec bumper, World world, Pose2 robot) {
    for (double bearing = bumper.from(); bearing <= bumper.to(); bearing += STEP) {
      double angle = robot.yaw() + bearing;
      double reach = radius + REACH;
      if (!world.isFree(robot.x() + reach * Math.cos(angle), robot.y() + reach * Math.sin(angle), 0, height)) {
        return true;
      }
    }
    return false;
  }
}
