package org.robotui.sim.internal.nav;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.world.MapRasterizer;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.World;

class PlannerTest {
  /** A free place in each room of the demo. */
  private static final List<Pose2> PLACES = List.of(
      new Pose2(1.6, 3.4, 0), new Pose2(8.6, 1.0, 0), new Pose2(12.3, 2.6, 0), new Pose2(7, 5, 0),
      new Pose2(3.4, 9.0, 0), new Pose2(6.8, 8.9, 0), new Pose2(10.7, 7.5, 0));

  private final World world = World.demo();
  private final Clearance clearance = new Clearance(new MapRasterizer(world, 0.05, 0.3).rasterize());
  private final Planner planner = new Planner(clearance, 0.28);

  @Test
  void everyRoomIsReachedFromTheStart() {
    assertEquals(
        world.rooms().stream().map(room -> room.name()).sorted().toList(),
        PLACES.stream().map(p -> world.roomAt(p.x(), p.y()).orElseThrow().name()).sorted().toList());
    for (Pose2 place : PLACES) {
      List<Pose2> path = found(world.start(), place);
      assertEquals(place, path.getLast());
      assertEquals(world.start().x(), path.getFirst().x());
    }
  }

  @Test
  void pathsKeepTheirDistanceAndHaveNoJumps() {
    List<Pose2> path = found(PLACES.get(1), PLACES.get(4));
    for (int i = 1; i < path.size(); i++) {
      assertTrue(clearance.atPoint(path.get(i).x(), path.get(i).y()) >= 0.27, "at " + path.get(i));
      assertTrue(path.get(i).distanceTo(path.get(i - 1)) < 0.15);
    }
  }

  @Test
  void aGoalInAWallIsRefusedWithAReason() {
    Plan plan = planner.plan(world.start(), new Pose2(5, 2, 0));
    assertTrue(assertInstanceOf(Plan.Impossible.class, plan).reason().contains("obstacle"));
    assertInstanceOf(Plan.Impossible.class, planner.plan(world.start(), new Pose2(-50, 2, 0)));
    assertInstanceOf(Plan.Impossible.class, planner.plan(new Pose2(5, 2, 0), world.start()));
  }

  @Test
  void aRobotThatTouchesAWallFindsAWayOut() {
    Pose2 atWall = new Pose2(0.30, 5.0, 0);
    Pose2 touching = new Pose2(4.69, 2.5, 0);
    assertTrue(clearance.atPoint(touching.x(), touching.y()) < 0.28);
    assertTrue(found(touching, PLACES.get(3)).size() > 10);
    assertTrue(clearance.atPoint(atWall.x(), atWall.y()) < 0.28);
  }

  private List<Pose2> found(Pose2 from, Pose2 to) {
    return assertInstanceOf(Plan.Found.class, planner.plan(from, to), to.toString()).poses();
  }
}
