package org.robotui.sim.internal.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.message.ros.actionlib_msgs.GoalID;
import org.robotui.message.ros.actionlib_msgs.GoalStatus;
import org.robotui.sim.internal.GoalStatus.Phase;

class DriveGoalsTest {
  private static final long SECOND = 1_000_000_000;
  private final DriveGoals goals = new DriveGoals();

  private static GoalID id(String name) {
    return new GoalID(name.charAt(0) * SECOND, name);
  }

  private static org.robotui.sim.internal.GoalStatus robot(String id, Phase phase) {
    return new org.robotui.sim.internal.GoalStatus(1, id, phase, "in words");
  }

  private List<Integer> codes() {
    return goals.messages().stream().map(GoalStatus::status).toList();
  }

  @Test
  void aGoalIsPendingThenActiveThenReached() {
    assertEquals(GoalStatus.PENDING, goals.add(id("a"), 0).orElseThrow().status());
    assertEquals(List.of(), goals.follow(robot("", Phase.SUCCEEDED), 1));
    assertEquals(List.of(), goals.follow(robot("a", Phase.ACTIVE), 2));
    assertEquals(List.of(GoalStatus.ACTIVE), codes());
    List<DriveGoal> ended = goals.follow(robot("a", Phase.SUCCEEDED), 3);
    assertEquals(List.of(new DriveGoal(id("a"), GoalStatus.SUCCEEDED, "in words", 3)), ended);
    assertEquals(List.of(), goals.follow(robot("a", Phase.SUCCEEDED), 4));
  }

  @Test
  void aNewGoalReplacesThoseBefore() {
    goals.add(id("a"), 0);
    goals.add(id("b"), 0);
    goals.add(id("c"), 0);
    assertEquals(List.of("a"), goals.follow(robot("b", Phase.ACTIVE), 1).stream().map(goal -> goal.id().id()).toList());
    assertEquals(List.of(GoalStatus.PREEMPTED, GoalStatus.ACTIVE, GoalStatus.PENDING), codes());
  }

  @Test
  void aGoalWithoutAWayIsAborted() {
    goals.add(id("a"), 0);
    assertEquals(GoalStatus.ABORTED, goals.follow(robot("a", Phase.REJECTED), 1).get(0).status());
  }

  @Test
  void goalsAreCancelledByNameByTimeOrAll() {
    goals.add(id("a"), 0);
    goals.add(id("b"), 0);
    goals.add(id("c"), 0);
    assertEquals(List.of("b"), goals.cancel(new GoalID(0, "b"), 1));
    assertEquals(List.of(GoalStatus.PENDING, GoalStatus.PREEMPTING, GoalStatus.PENDING), codes());
    assertEquals(List.of("a", "b"), goals.cancel(new GoalID('b' * SECOND, ""), 1));
    assertEquals(List.of("a", "b", "c"), goals.cancel(new GoalID(0, ""), 1));
  }

  @Test
  void aCancellationThatCameFirstRecallsTheGoal() {
    goals.cancel(new GoalID(0, "a"), 1);
    assertEquals(GoalStatus.RECALLED, goals.add(id("a"), 2).orElseThrow().status());
    assertEquals(GoalStatus.PENDING, goals.add(id("b"), 2).orElseThrow().status());
  }

  @Test
  void aGoalThatCameTwiceOrOneTooManyIsNotTaken() {
    goals.add(id("a"), 0);
    assertEquals(Optional.empty(), goals.add(id("a"), 0));
    for (int i = 0; i < 500; i++) {
      goals.add(new GoalID(1, "g" + i), 0);
      goals.cancel(new GoalID(0, "unknown" + i), 0);
    }
    assertTrue(goals.messages().size() <= 200);
  }

  @Test
  void goalsThatEndedAreForgottenAfterFiveSeconds() {
    DriveGoal goal = goals.add(id("a"), 0).orElseThrow();
    assertEquals(GoalStatus.REJECTED, goals.refuse(goal, "no", 0).status());
    goals.follow(robot("", Phase.SUCCEEDED), 4 * SECOND);
    assertEquals(1, goals.messages().size());
    goals.follow(robot("", Phase.SUCCEEDED), 6 * SECOND);
    assertEquals(List.of(), goals.messages());
  }
}
