package org.robotui.entity.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.scene.Bounds;

class RobotEntityTest {
  @Test
  void aBodyIsFoundWithinItsRadius() {
    RobotEntity entity = new RobotEntity(0);
    entity.prepare(new Body("Keira", RigidTransform.planar(1, 2, 0), 0.3, Optional.empty(), "x 1  y 2"));
    assertEquals("Keira\nx 1  y 2", entity.describeAt(1.2, 2, 0).orElseThrow().text());
    assertTrue(entity.describeAt(1.5, 2, 0.1).isEmpty());
    assertEquals(new Bounds(0.7, 1.7, 1.3, 2.3), entity.bounds().orElseThrow());
    entity.clear();
    assertTrue(entity.bounds().isEmpty());
  }

  @Test
  void aBodyHasASize() {
    assertThrows(IllegalArgumentException.class,
        () -> new Body("Keira", RigidTransform.IDENTITY, 0, Optional.empty(), ""));
  }

  @Test
  void anEstimateSaysHowSureItIs() {
    double[] c = new double[36];
    c[0] = 0.04;
    c[7] = 0.01;
    c[35] = Math.pow(Math.toRadians(5), 2);
    PoseEntity entity = new PoseEntity();
    FrameId odom = new FrameId("Keira", "odom");
    entity.prepare(new PoseEstimate(odom, RigidTransform.planar(1, 0, 0), Doubles.of(c)),
        RigidTransform.planar(2, 0, 0));
    String text = entity.describeAt(3, 0, 0.1).orElseThrow().text();
    assertTrue(text.endsWith("\u03c3 0.20\u00a0m, 5.0\u00b0"), text);
    assertTrue(text.contains("x 1.00  y 0.00"), text);
  }
}
