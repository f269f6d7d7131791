package org.robotui.sim.internal.nav;

import java.util.List;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Angles;
import org.robotui.sim.internal.world.Pose2;

/** Pure pursuit of one path. For one thread. */
final class PathFollower {
  private static final double LOOK_AHEAD = 0.32;
  private static final double ARRIVAL_DISTANCE = 0.06;
  private static final double ARRIVAL_ANGLE = Math.toRadians(3);
  private static final double TURN_ON_SPOT = Math.toRadians(50);
  private static final double SLOW_DOWN = 0.8;

  private final List<Pose2> path;
  private final Speed cruise;
  private int nearest;
  private boolean atGoal;

  /** @param cruise the speeds not to be exceeded */
  PathFollower(List<Pose2> path, Speed cruise) {
    this.path = path;
    this.cruise = cruise;
  }

  private Pose2 goal() {
    return path.getLast();
  }

  boolean hasArrived(Pose2 here) {
    atGoal |= here.distanceTo(goal()) < ARRIVAL_DISTANCE;
    return atGoal && Math.abs(Angles.wrap(goal().yaw() - here.yaw())) < ARRIVAL_ANGLE;
  }

  /** The speed to go on with from here. */
  Speed follow(Pose2 here) {
    if (atGoal) {
      return turn(Angles.wrap(goal().yaw() - here.yaw()));
    }
    Pose2 target = target(here);
    Pose2 seen = here.inverse().times(target);
    double bearing = Math.atan2(seen.y(), seen.x());
    if (Math.abs(bearing) > TURN_ON_SPOT) {
      return turn(bearing);
    }
    double distance = Math.max(0.05, Math.hypot(seen.x(), seen.y()));
    double linear = cruise.linear() * Math.cos(bearing) * Math.cos(bearing) * approach(here);
    double angular = 2 * linear * Math.sin(bearing) / distance + 0.4 * bearing;
    return new Speed(linear, Math.clamp(angular, -cruise.angular(), cruise.angular()));
  }

  private double approach(Pose2 here) {
    return Math.clamp(here.distanceTo(goal()) / SLOW_DOWN, 0.12, 1);
  }

  private Speed turn(double error) {
    double rate = Math.clamp(2.2 * error, -cruise.angular(), cruise.angular());
    return new Speed(0, Math.copySign(Math.max(Math.abs(rate), 0.08), error));
  }

  private Pose2 target(Pose2 here) {
    while (nearest < path.size() - 1
        && path.get(nearest + 1).distanceTo(here) <= path.get(nearest).distanceTo(here)) {
      nearest++;
    }
    int ahead = nearest;
    while (ahead < path.size() - 1 && path.get(ahead).distanceTo(here) < LOOK_AHEAD) {
      ahead++;
    }
    return path.get(ahead);
  }
}
