package org.robotui.sim.internal.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class WalkerTest {
  private static final List<Pose2> SQUARE =
      List.of(new Pose2(0, 0, 0), new Pose2(2, 0, 0), new Pose2(2, 2, 0), new Pose2(0, 2, 0));
  private static final Pose2 FAR = new Pose2(50, 50, 0);

  @Test
  void itWalksRoundAndRound() {
    Walker walker = new Walker(SQUARE);
    walk(walker, FAR, 5);
    assertEquals(new Pose2(2, 1, Math.PI / 2), rounded(walker.place()));
    walk(walker, FAR, 8.0 / 0.6);
    assertEquals(0, walker.place().distanceTo(new Pose2(2, 1, 0)), 0.02);
  }

  @Test
  void itTurnsBackBeforeTheRobotAndNeverComesNear() {
    Walker walker = new Walker(SQUARE);
    Pose2 robot = new Pose2(2, 0, 0);
    double nearest = Double.POSITIVE_INFINITY;
    boolean otherSide = false;
    for (int i = 0; i < 6000; i++) {
      walker.step(robot, 0.01);
      nearest = Math.min(nearest, walker.place().distanceTo(robot));
      otherSide |= walker.place().distanceTo(new Pose2(0, 2, 0)) < 0.1;
    }
    assertTrue(nearest >= 0.89, "as near as " + nearest);
    assertTrue(otherSide, "it went the other way round");
  }

  @Test
  void onePlaceIsNoWalk() {
    assertThrows(IllegalArgumentException.class, () -> new Walker(SQUARE.subList(0, 1)));
  }

  private static void walk(Walker walker, Pose2 robot, double seconds) {
    for (int i = 0; i < Math.round(seconds * 100); i++) {
      walker.step(robot, 0.01);
    }
  }

  private static Pose2 rounded(Pose2 pose) {
    return new Pose2(Math.round(pose.x() * 100) / 100.0, Math.round(pose.y() * 100) / 100.0, pose.yaw());
  }
}
