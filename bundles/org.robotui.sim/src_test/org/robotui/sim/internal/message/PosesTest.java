package org.robotui.sim.internal.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.message.ros.geometry_msgs.Point;
import org.robotui.message.ros.geometry_msgs.Pose;
import org.robotui.message.ros.geometry_msgs.Quaternion;
import org.robotui.sim.internal.world.Pose2;

class PosesTest {
  @Test
  void aPoseComesBackFromItsMessage() {
    Pose2 back = Poses.planar(Poses.pose(new Pose2(1, -2, 2.5)));
    assertEquals(1, back.x());
    assertEquals(-2, back.y());
    assertEquals(2.5, back.yaw(), 1e-9);
  }

  @Test
  void aZeroQuaternionCountsAsNoRotation() {
    assertEquals(0, Poses.planar(new Pose(new Point(1, 2, 0), new Quaternion(0, 0, 0, 0))).yaw());
  }

  @Test
  void whatIsNotFiniteIsSeen() {
    assertTrue(Poses.isFinite(Poses.pose(Pose2.ORIGIN)));
    assertFalse(Poses.isFinite(new Pose(new Point(Double.NaN, 2, 0), new Quaternion(0, 0, 0, 1))));
  }
}
