package org.robotui.urdf;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

class KinematicsTest {
  private final RobotModel arm = UrdfTest.arm();
  private final Kinematics kinematics = new Kinematics(arm);

  static void assertNear(double x, double y, double z, Vector3 at, double tolerance) {
    assertEquals(x, at.x(), tolerance);
    assertEquals(y, at.y(), tolerance);
    assertEquals(z, at.z(), tolerance);
  }

  @Test
  void turnsSlidesAndMimics() {
    Map<String, RigidTransform> places = kinematics.rootFromLinks(Map.of("turn", Math.PI / 2, "lift", 0.3), Map.of());
    assertNear(0, 0, 1.8, places.get("slide").translation(), 1e-12);
    // -2 times 0.3 plus 0.1 along x, which the column turned to y
    assertNear(0, -0.5, 1.8, places.get("finger").translation(), 1e-12);
    assertEquals(arm.links().size(), places.size());
  }

  @Test
  void takesWhereFreeJointsAre() {
    RigidTransform there = RigidTransform.planar(1, 2, 0.5);
    assertEquals(there, kinematics.rootFromLinks(Map.of(), Map.of("free", there)).get("cube"));
    assertNear(0, 0, 0, kinematics.rootFromLinks(Map.of(), Map.of()).get("cube").translation(), 0);
  }

  @Test
  void takesWhatIsNoNumberAsZero() {
    assertNear(0, 0, 1.5, kinematics.rootFromLinks(Map.of("lift", Double.NaN), Map.of()).get("slide").translation(),
        1e-12);
  }
}
