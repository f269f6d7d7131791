package org.robotui.uic.map.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.layer.SeenRobot;
import org.robotui.uic.map.internal.model.GoalFailure;
import org.robotui.uic.map.internal.model.MapSnapshot;

class SentGoalTest {
  private static final FrameId MAP = new FrameId("Keira", "map");
  private static final Vector3 GOAL = new Vector3(5, 2, 0);
  private static final Vector3 ELSEWHERE = new Vector3(1, 1, 0);
  private static final long LATE = (SentGoal.PATIENCE_MILLIS + 1) * 1_000_000L;

  private final SentGoal sent = new SentGoal();

  @Test
  void aGoalWithoutAWayIsSaidAfterAWhile() {
    sent.at(MAP, RigidTransform.planar(5, 2, 0), 0);
    assertEquals("", problem(LATE - 2_000_000L, ways(ELSEWHERE)));
    assertEquals(SentGoal.NO_PATH, problem(LATE, ways(ELSEWHERE)));
    assertEquals(SentGoal.NO_PATH, problem(LATE, ways()));
    assertEquals("", problem(2 * LATE, ways(GOAL)), "better late than never");
  }

  @Test
  void aWayThatGoesBeforeTheRobotIsThereIsSaid() {
    sent.at(MAP, RigidTransform.planar(5, 2, 0), 0);
    assertEquals("", problem(10 * LATE, ways(GOAL)));
    assertEquals("", problem(10 * LATE + 1, ways()), "it may be planned anew");
    assertEquals(SentGoal.GIVEN_UP, problem(11 * LATE + 1, ways()));
  }

  @Test
  void aGoalThatFailsSaysWhyAtOnce() {
    sent.at(MAP, RigidTransform.planar(5, 2, 0), 100);
    GoalFailure before = new GoalFailure(99, "aborted: the way is blocked");
    GoalFailure refused = new GoalFailure(101, "aborted: the goal is too close to an obstacle, or off the map");
    assertEquals("", sent.problem(snapshot(ways(), ELSEWHERE, before), 102), "of the goal before");
    assertEquals(refused.words(), sent.problem(snapshot(ways(), ELSEWHERE, before, refused), 102));
    assertEquals(refused.words(), sent.problem(snapshot(Optional.empty(), ELSEWHERE, refused), 102), "without a plan");
    assertEquals("goal " + refused.words(), sent.note(snapshot(ways(), ELSEWHERE, refused), 102).orElseThrow().text());
    sent.at(MAP, RigidTransform.planar(5, 2, 0), 103);
    assertEquals("", sent.problem(snapshot(ways(), ELSEWHERE, refused), 104), "a goal anew");
  }

  @Test
  void nothingIsSaidOfARobotThatDoesNotTellWhatItPlans() {
    sent.at(MAP, RigidTransform.planar(5, 2, 0), 0);
    assertEquals("", problem(LATE, Optional.empty()));
  }

  @Test
  void theGoalGoesWhenTheRobotIsThereOrTheUserIsDone() {
    sent.at(MAP, RigidTransform.planar(5, 2, 0), 0);
    assertTrue(sent.look(snapshot(ways(), ELSEWHERE), 1));
    assertFalse(sent.look(snapshot(ways(), GOAL), 2));

    sent.at(MAP, RigidTransform.planar(5, 2, 0), 3);
    sent.clear();
    assertEquals("", problem(LATE + 4, ways()));
  }

  private String problem(long now, Optional<List<Vector3>> ways) {
    MapSnapshot snapshot = snapshot(ways, ELSEWHERE);
    sent.look(snapshot, now);
    return sent.problem(snapshot, now);
  }

  private static Optional<List<Vector3>> ways(Vector3... ends) {
    return Optional.of(List.of(ends));
  }

  private static MapSnapshot snapshot(Optional<List<Vector3>> ways, Vector3 robot, GoalFailure... failed) {
    List<GoalFailure> failures = List.of(failed);
    SeenRobot place = new SeenRobot("Keira", RigidTransform.planar(robot.x(), robot.y(), 0), 0, 0, false, false);
    return new MapSnapshot(Optional.of(MAP), List.of(MAP), new InputState.Live(1, 0), List.of(), List.of(place), ways,
        failures, Set.of(), List.of());
  }
}
