package org.robotui.sim.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.robot.DriveLimits;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.MapRasterizer;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.TestWorlds;
import org.robotui.sim.internal.world.World;

class SimulationTest {
  private final List<Event> events = new ArrayList<>();

  private Simulation in(World world, long seed) {
    return new Simulation(
        world, new MapRasterizer(world, 0.05, 0.3).rasterize(), Settings.demo(seed), events::add);
  }

  @Test
  void itDrivesAsCommandedAndStopsHalfASecondAfterTheLastCommand() {
    Simulation simulation = in(TestWorlds.room(), 1);
    simulation.submit(new Command.Drive(new Speed(0.5, 0)));
    run(simulation, 0.49);
    assertTrue(simulation.state().speed().linear() > 0.4);
    run(simulation, 0.4);
    assertEquals(Speed.ZERO, simulation.state().speed());
    assertTrue(hasEvent("timed out"));
    assertTrue(simulation.state().truth().x() > 5.1);
  }

  @Test
  void repeatedCommandsKeepItGoing() {
    Simulation simulation = in(TestWorlds.room(), 1);
    driveFor(simulation, new Speed(0.5, 0), 3);
    assertEquals(0.5, simulation.state().speed().linear(), 1e-9);
    assertFalse(hasEvent("timed out"));
    assertEquals(5 + 1.36, simulation.state().truth().x(), 0.02);
  }

  @Test
  void itStopsAtAWallAndComesFreeBackwards() {
    Simulation simulation = in(TestWorlds.room(), 1);
    driveFor(simulation, new Speed(0.7, 0), 12);
    double x = simulation.state().truth().x();
    assertEquals(9.9 - 0.25, x, 0.02);
    assertTrue(x <= 9.65);
    assertTrue(simulation.state().bumped());
    assertTrue(simulation.state().speed().linear() < 0.02);
    assertTrue(hasEvent("bumped"));
    assertEquals(1, events.stream().filter(e -> e.text().contains("bumped")).count());
    driveFor(simulation, new Speed(-0.5, 0), 2);
    assertTrue(simulation.state().truth().x() < 9.2);
    assertFalse(simulation.state().bumped());
  }

  @Test
  void odometryDriftsFromTheTruthButTheEstimateDoesNot() {
    World world = World.demo();
    Simulation simulation = in(world, 4);
    simulation.submit(new Command.Goal("g", new Pose2(12.3, 2.6, 0)));
    run(simulation, 60);
    RobotState state = simulation.state();
    Pose2 reckoned = world.start().times(state.odometry());
    assertTrue(reckoned.distanceTo(state.truth()) > 0.04, "drift " + reckoned.distanceTo(state.truth()));
    assertTrue(reckoned.distanceTo(state.truth()) < 1.5);
    assertTrue(state.estimate().distanceTo(state.truth()) < 0.08);
    assertNotEquals(world.start(), state.mapFromOdometry());
  }

  @Test
  void itDrivesToAGoalInEachRoomWithoutTouchingAnything() {
    List<Pose2> tour = List.of(
        new Pose2(8.6, 1.0, 1), new Pose2(12.3, 2.6, 2), new Pose2(10.7, 7.5, 0), new Pose2(6.8, 8.9, -2),
        new Pose2(3.4, 9.0, 3), new Pose2(2.6, 2.3, 0.7));
    Simulation simulation = in(World.demo(), 2);
    for (Pose2 goal : tour) {
      events.clear();
      simulation.submit(new Command.Goal("g", goal));
      runUntilGoalEnds(simulation, 90);
      assertTrue(hasEvent("goal reached"), goal + ": " + events);
      assertFalse(hasEvent("bumped"), events.toString());
      assertTrue(simulation.state().truth().distanceTo(goal) < 0.2);
      assertEquals(GoalStatus.Phase.SUCCEEDED, simulation.state().goalStatus().phase());
    }
  }

  @Test
  void aCommandEndsNavigation() {
    Simulation simulation = in(World.demo(), 1);
    simulation.submit(new Command.Goal("g", new Pose2(7, 5, 0)));
    run(simulation, 2);
    assertTrue(simulation.state().path().size() > 10);
    simulation.submit(new Command.Drive(new Speed(0, 0.3)));
    run(simulation, 2);
    assertEquals(Optional.empty(), simulation.state().goal());
    assertTrue(simulation.state().path().isEmpty());
    assertEquals(Speed.ZERO, simulation.state().speed());
    assertTrue(hasEvent("cancelled"));
    assertEquals(GoalStatus.Phase.PREEMPTED, simulation.state().goalStatus().phase());
  }

  @Test
  void aGoalInAWallIsRefused() {
    Simulation simulation = in(World.demo(), 1);
    simulation.submit(new Command.Goal("g", new Pose2(5, 2, 0)));
    run(simulation, 1);
    assertTrue(hasEvent("goal refused"));
    assertEquals(GoalStatus.Phase.REJECTED, simulation.state().goalStatus().phase());
    assertEquals(Speed.ZERO, simulation.state().speed());
  }

  @Test
  void aLostRobotStopsBeforeObstaclesAndGivesUp() {
    Simulation simulation = in(World.demo(), 1);
    simulation.submit(new Command.InitialPose(new Pose2(7, 5, 0)));
    run(simulation, 0.5);
    simulation.submit(new Command.Goal("g", new Pose2(13, 5, 0)));
    runUntilGoalEnds(simulation, 60);
    assertTrue(simulation.state().lost());
    assertTrue(hasEvent("goal aborted: the way is blocked"), events.toString());
    assertFalse(hasEvent("bumped"), events.toString());
  }

  @Test
  void withMotorsOffNothingMoves() {
    Simulation simulation = in(TestWorlds.room(), 1);
    simulation.submit(new Command.Motors(false));
    driveFor(simulation, new Speed(0.5, 0.5), 1);
    assertEquals(5, simulation.state().truth().x());
    assertFalse(simulation.state().motorsOn());
  }

  @Test
  void onlyTheGoalThatIsMeantIsCancelled() {
    Simulation simulation = in(World.demo(), 1);
    simulation.submit(new Command.Goal("mine", new Pose2(7, 5, 0)));
    simulation.submit(new Command.Cancel("another"));
    run(simulation, 1);
    assertTrue(simulation.state().goal().isPresent());
    simulation.submit(new Command.Cancel("mine"));
    run(simulation, 0.1);
    assertEquals(Optional.empty(), simulation.state().goal());
    assertEquals("mine", simulation.state().goalStatus().id());
    assertEquals(GoalStatus.Phase.PREEMPTED, simulation.state().goalStatus().phase());
  }

  @Test
  void limitsHoldFromTheMomentTheyAreSet() {
    Simulation simulation = in(TestWorlds.room(), 1);
    driveFor(simulation, new Speed(0.7, 0), 1);
    Tuning slow = new Tuning(new DriveLimits(0.2, 0.5, 1, 1), Tuning.Style.CAREFUL, true);
    simulation.submit(new Command.Tune(slow));
    driveFor(simulation, new Speed(0.7, 0), 1);
    assertEquals(0.2, simulation.state().speed().linear(), 1e-9);
    assertEquals(slow, simulation.state().tuning());
  }

  @Test
  void somebodyWalksAndIsSeenByTheLaserUnlessToldNotTo() {
    Simulation simulation = in(World.demo(), 1);
    Pose2 before = simulation.state().person().orElseThrow();
    run(simulation, 2);
    Pose2 after = simulation.state().person().orElseThrow();
    assertEquals(1.2, before.distanceTo(after), 0.02);
    assertEquals(1 - 0.18, simulation.present().range(after.x() - 1, after.y(), 0, 0.3, 5), 0.01);
    assertTrue(simulation.world().range(after.x() - 1, after.y(), 0, 0.3, 5) > 1);
    simulation.submit(new Command.Tune(new Tuning(DriveLimits.DEMO, Tuning.Style.NORMAL, false)));
    run(simulation, 1);
    assertEquals(after, simulation.state().person().orElseThrow());
    assertEquals(Optional.empty(), in(TestWorlds.room(), 1).state().person());
  }

  @Test
  void resetPutsEverythingBack() {
    Simulation simulation = in(TestWorlds.room(), 1);
    driveFor(simulation, new Speed(0.5, 0.5), 3);
    simulation.submit(new Command.Reset());
    run(simulation, 0.01);
    RobotState state = simulation.state();
    assertEquals(new Pose2(5, 3, 0), state.truth());
    assertEquals(Pose2.ORIGIN, state.odometry());
    assertEquals(Speed.ZERO, state.speed());
    assertEquals(0.87, state.battery().level(), 1e-3);
    assertEquals(1, state.resets());
  }

  @Test
  void theSameSeedGivesTheSameRun() {
    assertEquals(endOfRun(5), endOfRun(5));
    assertNotEquals(endOfRun(5).odometry(), endOfRun(6).odometry());
  }

  private RobotState endOfRun(long seed) {
    Simulation simulation = in(World.demo(), seed);
    simulation.submit(new Command.Goal("g", new Pose2(7, 5, 0)));
    run(simulation, 10);
    return simulation.state();
  }

  private boolean hasEvent(String text) {
    return events.stream().anyMatch(event -> event.text().contains(text));
  }

  private static void run(Simulation simulation, double seconds) {
    for (int i = 0; i < Math.round(seconds / Simulation.STEP); i++) {
      simulation.step();
    }
  }

  private static void driveFor(Simulation simulation, Speed speed, double seconds) {
    for (int i = 0; i < Math.round(seconds * 10); i++) {
      simulation.submit(new Command.Drive(speed));
      run(simulation, 0.1);
    }
  }

  private static void runUntilGoalEnds(Simulation simulation, double seconds) {
    run(simulation, 0.1);
    double end = simulation.state().time() + seconds;
    while (simulation.state().goal().isPresent() && simulation.state().time() < end) {
      simulation.step();
    }
  }
}
