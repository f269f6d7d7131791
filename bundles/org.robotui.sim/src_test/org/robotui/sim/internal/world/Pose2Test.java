package org.robotui.sim.internal.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class Pose2Test {
  @Test
  void aQuarterCircleEndsWhereGeometrySays() {
    double radius = 2;
    Pose2 end = new Pose2(1, 1, 0).advance(radius * Math.PI / 2, Math.PI / 2);
    assertEquals(3, end.x(), 1e-12);
    assertEquals(3, end.y(), 1e-12);
    assertEquals(Math.PI / 2, end.yaw(), 1e-12);
  }

  @Test
  void theInverseUndoes() {
    Pose2 pose = new Pose2(1.2, -3, 2.5);
    Pose2 nothing = pose.times(pose.inverse());
    assertEquals(0, Math.hypot(nothing.x(), nothing.y()), 1e-12);
    assertEquals(0, nothing.yaw(), 1e-12);
  }

  @Test
  void headingsStayWithinHalfATurn() {
    assertEquals(Math.PI - 0.5, new Pose2(0, 0, -Math.PI - 0.5).yaw(), 1e-12);
    assertEquals(Math.PI, Angles.wrap(-Math.PI), 1e-12);
  }
}
