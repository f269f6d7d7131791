package org.robotui.sim.internal.swarm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class WalkerTest {
  private final Hall hall = Hall.forRobots(20);

  private Walker at(double x, double y) {
    return new Walker(hall, x, y, new Random(3));
  }

  private static void pass(double seconds, List<Walker> all) {
    for (double t = 0; t < seconds; t += 0.05) {
      all.forEach(w -> w.step(0.05, all));
    }
  }

  @Test
  void goesRoundAPillarToItsGoalAndStaysThere() {
    Walker walker = at(6, 5);
    Hall.Pillar pillar = hall.pillars().getFirst();
    walker.go(new Walker.Goal(pillar.x(), pillar.y() + 3));
    pass(40, List.of(walker));
    assertEquals(Walker.Task.ARRIVED, walker.task());
    assertEquals(0, Math.hypot(walker.x() - pillar.x(), walker.y() - pillar.y() - 3), 0.3);
    assertEquals(0, walker.linear(), 1e-9);
  }

  @Test
  void aZeroEndsItsGoalAndItStaysStanding() {
    Walker walker = at(3, 3);
    walker.go(new Walker.Goal(10, 20));
    pass(2, List.of(walker));
    walker.drive(0, 0);
    pass(3, List.of(walker));
    double x = walker.x();
    pass(5, List.of(walker));
    assertEquals(Walker.Task.STANDING, walker.task());
    assertEquals(x, walker.x(), 1e-9);
  }

  @Test
  void whatIsNotToldAgainEnds() {
    Walker walker = at(3, 3);
    walker.drive(9, 0);
    pass(0.5, List.of(walker));
    assertTrue(walker.linear() > 0.3 && walker.linear() <= 0.6, "as fast as it can be");
    pass(2, List.of(walker));
    assertEquals(0, walker.linear(), 1e-9);
  }

  @Test
  void aGoalInAWallIsGivenUp() {
    Walker walker = at(3, 3);
    walker.go(new Walker.Goal(3, -5));
    pass(60, List.of(walker));
    assertEquals(Walker.Task.GAVE_UP, walker.task());
  }

  @Test
  void nobodyLeavesTheHallOrDrivesThroughAnother() {
    List<Walker> all = new ArrayList<>();
    for (int i = 0; i < 20; i++) {
      all.add(new Walker(hall, 2 + i % 5 * 4, 2 + i / 5 * 5.0, new Random(i)));
    }
    for (int second = 0; second < 60; second++) {
      pass(1, all);
      all.forEach(w -> assertTrue(hall.isFree(w.x(), w.y(), Walker.RADIUS), w.x() + " " + w.y()));
      all.forEach(w -> all.stream().filter(o -> o != w)
          .forEach(o -> assertTrue(Math.hypot(o.x() - w.x(), o.y() - w.y()) > 1.9 * Walker.RADIUS)));
    }
  }

  @Test
  void seesWallsAndOthers() {
    Walker walker = at(3, 3);
    Walker other = at(3, 5);
    float[] ranges = walker.scan(360, List.of(walker, other));
    float least = Float.POSITIVE_INFINITY;
    int seen = 0;
    for (float range : ranges) {
      least = Math.min(least, range);
      seen += Float.isFinite(range) ? 1 : 0;
    }
    assertEquals(2 - Walker.RADIUS, least, 0.01);
    assertTrue(seen > 100 && seen < 360, "some beams see nothing: " + seen);
  }
}
