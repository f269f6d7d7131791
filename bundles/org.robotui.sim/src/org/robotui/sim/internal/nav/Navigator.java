package org.robotui.sim.internal.nav;

import java.util.List;
import java.util.Optional;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.Pose2;

/** Drives to one goal at a time, by what localisation believes and the laser sees. For one thread. */
public final class Navigator {
  private static final double STOP_DISTANCE = 0.10;
  private static final double REPLAN_AFTER = 2;
  private static final double GIVE_UP_AFTER = 8;

  private final Planner planner;
  private Speed cruise;
  private Optional<Pose2> goal = Optional.empty();
  private List<Pose2> path = List.of();
  private PathFollower follower;
  private double blockedFor;

  public Navigator(Planner planner, Speed cruise) {
    this.planner = planner;
    this.cruise = cruise;
    follower = new PathFollower(List.of(Pose2.ORIGIN), cruise);
  }

  /** Changes the speeds not to be exceeded, also of the drive under way. */
  public void cruise(Speed speeds) {
    cruise = speeds;
    if (goal.isPresent()) {
      follower = new PathFollower(path, cruise);
    }
  }

  public Optional<Pose2> goal() {
    return goal;
  }

  /** The way that is being driven, in the map; empty without a goal. */
  public List<Pose2> path() {
    return path;
  }

  /** Takes a goal in place of the one before; where there is no way, it has none afterwards. */
  public Plan start(Pose2 wish, Pose2 estimate) {
    cancel();
    Plan plan = planner.plan(estimate, wish);
    if (plan instanceof Plan.Found found) {
      goal = Optional.of(wish);
      take(found);
    }
    return plan;
  }

  private void take(Plan.Found found) {
    path = found.poses();
    follower = new PathFollower(path, cruise);
  }

  public void cancel() {
    goal = Optional.empty();
    path = List.of();
    blockedFor = 0;
  }

  /**
   * Goes on for {@code dt} seconds.
   *
   * @param room free distance before the robot, metres
   */
  public Progress update(Pose2 estimate, double room, double dt) {
    if (goal.isEmpty()) {
      return new Progress.Idle();
    }
    if (follower.hasArrived(estimate)) {
      cancel();
      return new Progress.Reached();
    }
    Speed speed = follower.follow(estimate);
    boolean blocked = room < STOP_DISTANCE && speed.linear() > 0;
    double before = blockedFor;
    blockedFor = blocked ? blockedFor + dt : 0;
    if (blockedFor > GIVE_UP_AFTER) {
      return abort("the way is blocked");
    }
    if (before < REPLAN_AFTER && blockedFor >= REPLAN_AFTER) {
      return replan(goal.get(), estimate);
    }
    return new Progress.Driving(blocked ? new Speed(0, speed.angular()) : slowed(speed, room));
  }

  private static Speed slowed(Speed speed, double room) {
    double factor = Math.clamp(room / 0.5, 0.25, 1);
    return new Speed(speed.linear() * factor, speed.angular() * factor);
  }

  private Progress replan(Pose2 wish, Pose2 estimate) {
    return switch (planner.plan(estimate, wish)) {
      case Plan.Found found -> {
        take(found);
        yield new Progress.Driving(Speed.ZERO);
      }
      case Plan.Impossible impossible -> abort(impossible.reason());
    };
  }

  private Progress abort(String reason) {
    cancel();
    return new Progress.Aborted(reason);
  }
}
