package org.robotui.sim.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.model.Robots;
import org.robotui.sim.internal.robot.Neck;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.world.MapRasterizer;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.TestWorlds;
import org.robotui.sim.internal.world.World;

/** The robot with bumpers, in its apartment and at walls. */
class KeiraTest {
  private static final double RADIUS = Robots.KEIRA.radius();
  private final List<Event> events = new ArrayList<>();

  private Simulation in(World world) {
    return new Simulation(world, new MapRasterizer(world, 0.05, Robots.KEIRA.laser().height()).rasterize(),
        Settings.of(Robots.KEIRA, 2), events::add);
  }

  private static void run(Simulation simulation, double seconds) {
    for (int i = 0; i < Math.round(seconds / Simulation.STEP); i++) {
      simulation.step();
    }
  }

  private static void drive(Simulation simulation, double linear, double angular, double seconds) {
    simulation.submit(new Command.Drive(new Speed(linear, angular), seconds));
    run(simulation, seconds);
  }

  @Test
  void aWallAheadPressesBothBumpersAndOnlyBackingOffFreesThem() {
    Simulation simulation = in(TestWorlds.room());
    drive(simulation, 0.5, 0, 12);
    assertEquals(List.of(true, true), simulation.state().bumpers());
    assertEquals(9.9 - RADIUS, simulation.state().truth().x(), 0.02);
    assertEquals(Speed.ZERO, simulation.state().speed());
    drive(simulation, 0.5, 0, 1);
    assertEquals(List.of(true, true), simulation.state().bumpers());
    drive(simulation, -0.2, 0, 1);
    assertEquals(List.of(false, false), simulation.state().bumpers());
    assertTrue(simulation.state().truth().x() < 9.6);
  }

  @Test
  void aWallAskewPressesTheBumperOfItsSide() {
    Simulation simulation =
        in(TestWorlds.of("room hall 0 0 10 6 tile 808080 c04040\nwall 10 0 10 6 0.2\nstart 9 3 40\n"));
    drive(simulation, 0.3, 0, 6);
    assertEquals(List.of(false, true), simulation.state().bumpers());
  }

  @Test
  void aBumperEndsTheWayToAGoal() {
    World world = TestWorlds.of("room hall 0 0 10 6 tile 808080 c04040\nbox 101010 6 2 7 4 0.12\nstart 4.5 3 0\n");
    Simulation simulation = in(world);
    simulation.submit(new Command.Goal("g", new Pose2(8.5, 3, 0)));
    run(simulation, 20);
    assertEquals(GoalStatus.Phase.ABORTED, simulation.state().goalStatus().phase());
    assertTrue(simulation.state().bumpers().contains(true), simulation.state().truth().toString());
    assertEquals("goal aborted: a bumper is pressed", simulation.state().goalStatus().text());
  }

  @Test
  void everyRoomOfTheApartmentIsReached() {
    Simulation simulation = in(World.of("apartment"));
    List<Pose2> tour = List.of(new Pose2(2.6, 5.6, 1), new Pose2(4.2, 5.2, 2), new Pose2(6, 3.6, 0),
        new Pose2(6.4, 1.6, -2), new Pose2(6, 5, 3));
    for (Pose2 goal : tour) {
      simulation.submit(new Command.Goal("g", goal));
      run(simulation, 0.1);
      double end = simulation.state().time() + 90;
      while (simulation.state().goal().isPresent() && simulation.state().time() < end) {
        simulation.step();
      }
      assertEquals(GoalStatus.Phase.SUCCEEDED, simulation.state().goalStatus().phase(), goal + ": " + events);
    }
    assertFalse(events.stream().anyMatch(event -> event.text().contains("bumped")), events.toString());
  }

  @Test
  void itApproachesAPlaceOfOdometryAndStaysThere() {
    Simulation simulation = in(TestWorlds.room());
    simulation.submit(new Command.Approach(new Pose2(1, 0.5, 1), new Speed(0.3, 1)));
    run(simulation, 15);
    Pose2 odometry = simulation.state().odometry();
    assertEquals(0, odometry.distanceTo(new Pose2(1, 0.5, 0)), 0.07);
    assertEquals(1, odometry.yaw(), 0.06);
    assertEquals(Speed.ZERO, simulation.state().speed());
  }

  @Test
  void odometrySaysWhatItIsToldAndTheEstimateStays() {
    Simulation simulation = in(TestWorlds.room());
    drive(simulation, 0.3, 0.2, 2);
    Pose2 before = simulation.state().estimate();
    boolean[] done = {false};
    simulation.submit(new Command.SetOdometry(new Pose2(1, 2, 0.5)), () -> done[0] = true);
    assertFalse(done[0]);
    drive(simulation, 0, 0, 0.01);
    assertTrue(done[0]);
    assertEquals(0, simulation.state().odometry().distanceTo(new Pose2(1, 2, 0.5)), 0.01);
    assertEquals(0, simulation.state().estimate().distanceTo(before), 0.02);
  }

  @Test
  void onlyAHeadThatIsThereLooksWhereItIsTold() {
    Simulation keira = in(TestWorlds.room());
    assertEquals(Optional.empty(), keira.state().head());
    World world = TestWorlds.room();
    Simulation natalie =
        new Simulation(world, new MapRasterizer(world, 0.05, 0.3).rasterize(), Settings.demo(1), events::add);
    run(natalie, 4);
    assertEquals(0.9, natalie.state().head().orElseThrow().pan(), 0.01);
    natalie.submit(new Command.Turn(new Neck.Look(-0.5, 9, 1, 1)));
    run(natalie, 0.5);
    assertEquals(0.9 - 0.5, natalie.state().head().orElseThrow().pan(), 0.02);
    run(natalie, 2);
    assertEquals(-0.5, natalie.state().head().orElseThrow().pan(), 1e-6);
    assertEquals(0.6, natalie.state().head().orElseThrow().tilt(), 1e-6);
  }
}
