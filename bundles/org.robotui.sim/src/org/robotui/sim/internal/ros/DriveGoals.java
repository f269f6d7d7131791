package org.robotui.sim.internal.ros;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.robotui.sim.internal.GoalStatus.Phase;

/**
 * The goals of the action server in the order in which they came, with those that ended lately. The robot drives to the
 * last one only. For one thread at a time.
 */
final class DriveGoals {
  private static final long KEPT_NANOS = TimeUnit.SECONDS.toNanos(5);
  private static final int MOST = 200;
  private static final int MOST_EARLY = 50;

  private final List<DriveGoal> goals = new ArrayList<>();
  /** Goals that were cancelled before they came. */
  private final List<String> early = new ArrayList<>();

  /** Takes a goal; empty if it is known already, as when a client sends it twice, or if there are too many. */
  Optional<DriveGoal> add(GoalID id, long now) {
    if (goals.size() >= MOST || find(id.id()).isPresent()) {
      return Optional.empty();
    }
    DriveGoal goal = early.remove(id.id())
        ? new DriveGoal(id, GoalStatus.RECALLED, "cancelled before it came", now)
        : new DriveGoal(id, GoalStatus.PENDING, "", now);
    goals.add(goal);
    return Optional.of(goal);
  }

  private Optional<DriveGoal> find(String id) {
    return goals.stream().filter(goal -> goal.id().id().equals(id)).findFirst();
  }

  /** Ends a goal that the robot cannot take; answers it as it is then. */
  DriveGoal refuse(DriveGoal goal, String text, long now) {
    DriveGoal refused = goal.with(GoalStatus.REJECTED, text, now);
    goals.replaceAll(each -> each.id().equals(goal.id()) ? refused : each);
    return refused;
  }

  /** The names of the goals that a cancellation means: by name, by time, or all without both. */
  List<String> cancel(GoalID wish, long now) {
    boolean all = wish.id().isEmpty() && wish.stamp() == 0;
    List<String> meant = new ArrayList<>();
    goals.replaceAll(goal -> {
      boolean older = wish.stamp() != 0 && goal.id().stamp() <= wish.stamp();
      if (goal.isOver() || !(all || older || goal.id().id().equals(wish.id()))) {
        return goal;
      }
      meant.add(goal.id().id());
      return goal.with(GoalStatus.PREEMPTING, goal.text(), now);
    });
    if (!wish.id().isEmpty() && find(wish.id()).isEmpty() && early.size() < MOST_EARLY) {
      early.add(wish.id());
    }
    return meant;
  }

  /**
   * Follows the robot; answers the goals that ended with this. Those that came before the one it drives to are
   * replaced.
   */
  List<DriveGoal> follow(org.robotui.sim.internal.GoalStatus robot, long now) {
    List<DriveGoal> ended = new ArrayList<>();
    int current = indexOf(robot.id());
    for (int i = 0; i <= current; i++) {
      DriveGoal before = goals.get(i);
      if (!before.isOver()) {
        DriveGoal after =
            i < current ? before.with(GoalStatus.PREEMPTED, "goal replaced", now) : followed(before, robot, now);
        goals.set(i, after);
        if (after.isOver()) {
          ended.add(after);
        }
      }
    }
    goals.removeIf(goal -> goal.isOver() && now - goal.since() > KEPT_NANOS);
    return ended;
  }

  private int indexOf(String id) {
    for (int i = goals.size() - 1; i >= 0; i--) {
      if (goals.get(i).id().id().equals(id)) {
        return i;
      }
    }
    return -1;
  }

  private static DriveGoal followed(DriveGoal goal, org.robotui.sim.internal.GoalStatus robot, long now) {
    if (robot.phase() == Phase.ACTIVE) {
      return goal.status() == GoalStatus.PENDING ? goal.with(GoalStatus.ACTIVE, robot.text(), now) : goal;
    }
    int status = switch (robot.phase()) {
      case SUCCEEDED -> GoalStatus.SUCCEEDED;
      case PREEMPTED -> GoalStatus.PREEMPTED;
      default -> GoalStatus.ABORTED;
    };
    return goal.with(status, robot.text(), now);
  }

  /** The goal the robot drives to. */
  Optional<DriveGoal> active() {
    return goals.stream().filter(goal -> !goal.isOver() && goal.status() != GoalStatus.PENDING).findFirst();
  }

  List<GoalStatus> messages() {
    return goals.stream().map(DriveGoal::message).toList();
  }
}
