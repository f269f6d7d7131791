package org.robotui.entity.bumper;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.Bumper;
import org.robotui.data.sensor.Bumpers;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.scene.Bounds;

class BumperEntityTest {
  private static final FrameId BASE = new FrameId("Keira", "base_link");
  private static final double RADIUS = 0.2;

  private final BumperEntity entity = new BumperEntity();

  @Test
  void aBentBumperLiesOnTheRimOfTheRobot() {
    double length = Math.PI / 2 * RADIUS;
    Strip strip = Strip.of(0, new Bumper(RigidTransform.planar(RADIUS, 0, 0), length, RADIUS, true),
        RigidTransform.planar(1, 0, Math.PI / 2)).orElseThrow();
    for (int i = 0; i < strip.line().length; i += 2) {
      assertEquals(RADIUS, Math.hypot(strip.line()[i] - 1, strip.line()[i + 1]), 1e-9);
    }
    assertEquals(1 + RADIUS * Math.sin(Math.PI / 4), strip.line()[0], 1e-9, "it begins at its right end");
  }

  @Test
  void aStraightOneIsASegmentAndABendEndsAfterAFullTurn() {
    Strip straight =
        Strip.of(0, new Bumper(RigidTransform.planar(0.3, 0, 0), 0.4, 0, false), RigidTransform.IDENTITY).orElseThrow();
    assertEquals(4, straight.line().length);
    assertEquals(0.1, straight.distance(0.4, 0.1), 1e-9);
    Strip round =
        Strip.of(0, new Bumper(RigidTransform.planar(RADIUS, 0, 0), 1e9, RADIUS, false), RigidTransform.IDENTITY)
            .orElseThrow();
    assertEquals(0, round.distance(-RADIUS, 0), 1e-9);
    assertTrue(round.line().length < 200);
  }

  @Test
  void whichIsPressedIsDescribed() {
    entity.prepare(new Bumpers(BASE, List.of(new Bumper(RigidTransform.planar(0, 0.2, Math.PI / 2), 0.2, 0, false),
        new Bumper(RigidTransform.planar(0, -0.2, -Math.PI / 2), 0.2, 0, true))), RigidTransform.IDENTITY);
    assertEquals("bumper 1: pressed", entity.describeAt(0.05, -0.21, 0.05).orElseThrow().text());
    assertEquals("bumper 0: free", entity.describeAt(0, 0.2, 0.05).orElseThrow().text());
    assertTrue(entity.describeAt(0, 0, 0.05).isEmpty());
    Bounds bounds = entity.bounds().orElseThrow();
    assertEquals(0.2, bounds.maxY(), 1e-9);
  }

  @Test
  void aPlaceThatIsNotKnownIsNotDrawn() {
    entity.prepare(new Bumpers(BASE, List.of(new Bumper(RigidTransform.IDENTITY, 0, 0, true))),
        RigidTransform.IDENTITY);
    assertTrue(entity.bounds().isEmpty());
  }
}
