package org.robotui.entity.sonar;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.RangeReading;
import org.robotui.geometry.RigidTransform;

class SonarEntityTest {
  private static final FrameId FRONT = new FrameId("Keira", "sonar_3");

  @Test
  void aConeEndsAtItsEcho() {
    Cone cone = Cone.of(placed(1.5, RigidTransform.planar(1, 0, Math.PI / 2))).orElseThrow();
    assertTrue(cone.echo());
    assertEquals(1, cone.corners()[0], 1e-9);
    assertEquals(0, cone.distanceToArc(1, 1.5), 1e-6);
    assertEquals(1.5, cone.bounds().maxY(), 1e-9);
  }

  @Test
  void withoutAnEchoItReachesToTheLimit() {
    Cone cone = Cone.of(placed(Double.POSITIVE_INFINITY, RigidTransform.IDENTITY)).orElseThrow();
    assertFalse(cone.echo());
    assertEquals(3, cone.bounds().maxX(), 1e-9);
  }

  @Test
  void whatIsInvalidOrTooCloseIsNotDrawn() {
    assertTrue(Cone.of(placed(Double.NaN, RigidTransform.IDENTITY)).isEmpty());
    assertTrue(Cone.of(placed(Double.NEGATIVE_INFINITY, RigidTransform.IDENTITY)).isEmpty());
    assertTrue(Cone.of(placed(0.01, RigidTransform.IDENTITY)).isEmpty());
  }

  @Test
  void itsArcIsDescribed() {
    SonarEntity entity = new SonarEntity();
    entity.prepare(List.of(placed(1.5, RigidTransform.IDENTITY)));
    assertEquals("sonar sonar_3: 1.50\u00a0m", entity.describeAt(1.48, 0, 0.05).orElseThrow().text());
    assertTrue(entity.describeAt(0.7, 0, 0.05).isEmpty());
    entity.prepare(List.of());
    assertTrue(entity.bounds().isEmpty());
  }

  private static SonarEntity.Placed placed(double range, RigidTransform at) {
    return new SonarEntity.Placed(
        new RangeReading(FRONT, RangeReading.Kind.ULTRASOUND, Math.toRadians(30), 0.1, 3, range), at);
  }
}
