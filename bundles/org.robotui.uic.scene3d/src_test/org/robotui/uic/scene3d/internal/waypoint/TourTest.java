package org.robotui.uic.scene3d.internal.waypoint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.InputState;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeOutput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Health;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.ui.scene.Commander;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.ScenePorts;

class TourTest {
  private static final double TOLERANCE = 0.3;

  private final FakeUicContext context = new FakeUicContext("scene", SceneOptions.schema());
  private final FakeOutput<NavigationGoal> goals = context.output(ScenePorts.GOAL);
  private final List<CommandNotice> told = new ArrayList<>();
  private final Tour tour =
      new Tour(new Commander(context, ScenePorts.GOAL, ScenePorts.INITIAL_POSE), goals, context.principal(), told::add);
  private Route route = new Route(Optional.of(new FrameId("a", "map")),
      List.of(RigidTransform.planar(1, 0, 0), RigidTransform.planar(2, 0, 0),
          RigidTransform.planar(2, 2, Math.PI / 2)));
  private long now;

  private void at(double x, double y, double yaw) {
    now += 100_000_000L;
    tour.tick(route, Optional.of(RigidTransform.planar(x, y, yaw)), TOLERANCE, now);
  }

  private List<Double> sent() {
    return goals.sent().stream()
        .map(s -> s.command().pose().translation().x() + 10 * s.command().pose().translation().y()).toList();
  }

  private void begin() {
    tour.start(0);
    at(0, 0, 0);
  }

  private String ended() {
    assertEquals(OptionalInt.empty(), tour.driving());
    assertEquals(Health.WARNING, told.getLast().health());
    return told.getLast().text();
  }

  @Test
  void theNextGoalIsGivenWhenTheRobotIsNearTheLast() {
    begin();
    assertEquals(List.of(1.0), sent());
    at(0.6, 0, 0);
    at(0.9, 0, 2);
    assertEquals(List.of(1.0), sent(), "near, but it looks elsewhere");
    at(0.9, 0, 0.2);
    assertEquals(List.of(1.0, 2.0), sent());
    assertEquals(OptionalInt.of(1), tour.driving());
    at(1.9, 0.1, 0);
    at(2, 1.9, 1.6);
    assertEquals(List.of(1.0, 2.0, 22.0), sent());
    assertEquals(List.of(new CommandNotice(Health.OK, "The last waypoint is reached")), told);
    assertEquals(OptionalInt.empty(), tour.driving());
  }

  @Test
  void theStopEndsItForGood() {
    begin();
    context.authority().stop(FakeAuthority.ANNA);
    at(0.9, 0, 0);
    assertEquals("The drive ended at waypoint 1 of 3: stopped by Anna", ended());
    context.authority().releaseStop(FakeAuthority.ANNA);
    at(0.9, 0, 0);
    assertEquals(List.of(1.0), sent());
  }

  @Test
  void aLostOrReturnedLeaseEndsIt() {
    begin();
    context.authority().take(FakeAuthority.ANNA, true);
    at(0.9, 0, 0);
    assertTrue(ended().endsWith("Anna controls Keira now"));
    context.authority().giveBack(FakeAuthority.ANNA);
    begin();
    context.authority().giveBack(FakeAuthority.YOU);
    at(0.9, 0, 0);
    assertTrue(ended().endsWith("control was released"));
    assertEquals(2, sent().size());
  }

  @Test
  void aRefusedGoalOrALostLinkEndsItWithTheReason() {
    goals.outcome(() -> new CommandOutcome.Refused(CommandOutcome.Why.ROBOT, "nobody subscribes to /goal"));
    begin();
    assertEquals("Waypoint 1: Not sent: nobody subscribes to /goal", told.getLast().text());
    assertEquals(OptionalInt.empty(), tour.driving());
    goals.outcome(CommandOutcome.Accepted::new);
    begin();
    goals.state(new InputState.Unconnected("the link is lost"));
    at(0.5, 0, 0);
    assertTrue(ended().endsWith("the link is lost"));
  }

  @Test
  void aRobotThatStandsStillEndsIt() {
    begin();
    at(0.2, 0, 0);
    now += 29_000_000_000L;
    at(0.4, 0, 0);
    now += 29_000_000_000L;
    at(0.4, 0, 0);
    assertEquals(OptionalInt.of(0), tour.driving());
    now += 2_000_000_000L;
    at(0.4, 0, 0);
    assertTrue(ended().contains("has not moved for 30 s"));
  }

  @Test
  void theUserEndsItAndTheRobotStaysWhereItIs() {
    begin();
    tour.halt();
    at(0.5, 0, 0);
    assertTrue(ended().endsWith("you ended it"));
    assertEquals(List.of(1.0, 0.5), sent());
  }

  @Test
  void anotherGoalEndsItAndIsLeftAlone() {
    begin();
    tour.cede("another goal was given");
    at(0.5, 0, 0);
    assertTrue(ended().endsWith("another goal was given"));
    assertEquals(List.of(1.0), sent());
  }

  @Test
  void aWaypointThatMovesIsGivenAnewAndOneThatGoesEndsIt() {
    begin();
    route = route.with(0, RigidTransform.planar(1.5, 0, 0));
    at(0, 0, 0);
    assertEquals(List.of(1.0, 1.5), sent());
    route = Route.NONE;
    at(0, 0, 0);
    assertTrue(ended().endsWith("the waypoint was removed"));
  }

  @Test
  void withoutWaypointsItDoesNotBegin() {
    route = Route.NONE;
    begin();
    assertEquals(Health.BAD, told.getLast().health());
    assertEquals(List.of(), sent());
  }
}
