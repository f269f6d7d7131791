package org.robotui.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;

class QuaternionTest {
  private static final double NEAR = 1e-9;

  @Test
  void anglesComeBackAsTheyWereGiven() {
    RandomGenerator random = RandomGenerator.of("L64X128MixRandom");
    for (int i = 0; i < 1000; i++) {
      double roll = random.nextDouble(-3, 3);
      double pitch = random.nextDouble(-1.5, 1.5);
      double yaw = random.nextDouble(-3, 3);
      Quaternion q = Quaternion.fromRollPitchYaw(roll, pitch, yaw);
      assertEquals(roll, q.roll(), NEAR);
      assertEquals(pitch, q.pitch(), NEAR);
      assertEquals(yaw, q.yaw(), NEAR);
    }
  }

  @Test
  void aQuarterTurnToTheLeftTakesXToY() {
    assertNear(new Vector3(0, 1, 0), Quaternion.fromYaw(Math.PI / 2).rotate(new Vector3(1, 0, 0)));
  }

  @Test
  void slerpTakesTheShorterArc() {
    Quaternion half = Quaternion.fromYaw(0.2).slerp(Quaternion.fromYaw(1.0), 0.5);
    assertEquals(0.6, half.yaw(), NEAR);
    Quaternion opposite = new Quaternion(0, 0, -Math.sin(0.5), -Math.cos(0.5));
    assertEquals(0.6, Quaternion.fromYaw(0.2).slerp(opposite, 0.5).yaw(), NEAR);
  }

  @Test
  void whatIsNoRotationIsRefused() {
    assertThrows(ArithmeticException.class, () -> new Quaternion(0, 0, 0, 0).normalized());
    assertThrows(ArithmeticException.class, () -> new Quaternion(Double.NaN, 0, 0, 1).normalized());
  }

  @Test
  void aTransformAndItsInverseCancel() {
    RigidTransform t = new RigidTransform(new Vector3(1, -2, 3), Quaternion.fromRollPitchYaw(0.3, -0.4, 2));
    Vector3 p = new Vector3(0.5, 7, -1);
    assertNear(p, t.inverse().apply(t.apply(p)));
    assertNear(t.apply(t.apply(p)), t.times(t).apply(p));
  }

  private static void assertNear(Vector3 expected, Vector3 actual) {
    assertEquals(0, expected.minus(actual).norm(), NEAR, () -> expected + " but was " + actual);
  }
}
