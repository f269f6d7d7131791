package org.robotui.rfic.player.internal.convert;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.Vector3;
import org.robotui.player.interfaces.Body;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Pose3d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.interfaces.Position3d;
import org.robotui.player.interfaces.Size3d;

class MotionsTest {
  private static final FrameId ODOM = new FrameId("r", "odom");
  private static final FrameId BASE = new FrameId("r", "base_link");

  @Test
  void aPlanarStateIsOdometry() {
    Odometry o =
        Motions.odometry(new Position2d.State(new Pose2d(1, 2, 0.5), new Pose2d(0.3, 0.1, -0.2), true), ODOM, BASE);
    assertEquals(new Vector3(1, 2, 0), o.pose().translation());
    assertEquals(0.5, o.pose().rotation().yaw(), 1e-12);
    assertEquals(new Vector3(0.3, 0.1, 0), o.linear());
    assertEquals(new Vector3(0, 0, -0.2), o.angular());
  }

  @Test
  void aStateInSpaceIsOdometry() {
    Odometry o = Motions.odometry(
        new Position3d.State(new Pose3d(1, 2, 3, 0.1, 0.2, 0.3), new Pose3d(4, 5, 6, 7, 8, 9), false), ODOM, BASE);
    assertEquals(0.1, o.pose().rotation().roll(), 1e-12);
    assertEquals(0.2, o.pose().rotation().pitch(), 1e-12);
    assertEquals(0.3, o.pose().rotation().yaw(), 1e-12);
    assertEquals(new Vector3(4, 5, 6), o.linear());
    assertEquals(new Vector3(7, 8, 9), o.angular());
  }

  @Test
  void whatIsNoNumberIsRefused() {
    Position2d.State bad = new Position2d.State(new Pose2d(1, Double.NaN, 0), new Pose2d(0, 0, 0), false);
    assertTrue(assertThrows(IllegalArgumentException.class, () -> Motions.odometry(bad, ODOM, BASE)).getMessage()
        .contains("place"));
    Position2d.State fast =
        new Position2d.State(new Pose2d(1, 1, 0), new Pose2d(0, 0, Double.POSITIVE_INFINITY), false);
    assertThrows(IllegalArgumentException.class, () -> Motions.odometry(fast, ODOM, BASE));
  }

  @Test
  void aBodyIsARectangleAboutItsMiddle() {
    Footprint f = Motions
        .footprint(new Body(new Pose3d(-0.1, 0, 0, 4e-310, Double.NaN, 0), new Size3d(0.4, 0.6, Double.NaN)), BASE)
        .orElseThrow();
    assertEquals(0.2, f.corners().get(0).x(), 1e-12);
    assertEquals(0.2, f.corners().get(0).y(), 1e-12);
    assertEquals(-0.4, f.corners().get(2).x(), 1e-12);
    assertTrue(area(f) > 0, "counter-clockwise");
    assertTrue(Motions.footprint(new Body(new Pose3d(0, 0, 0, 0, 0, 0), new Size3d(0, 0, 0)), BASE).isEmpty());
  }

  private static double area(Footprint f) {
    double sum = 0;
    for (int i = 0; i < f.corners().size(); i++) {
      Vector3 a = f.corners().get(i);
      Vector3 b = f.corners().get((i + 1) % f.corners().size());
      sum += a.x() * b.y() - b.x() * a.y();
    }
    return sum / 2;
  }

  @Test
  void velocitiesLeaveTheMotorsOn() {
    VelocityCommand c = new VelocityCommand(new Vector3(1, 2, 3), new Vector3(4, 5, 6));
    assertEquals(new Position2d.Velocity(new Pose2d(1, 2, 6), true), Motions.planar(c));
    assertEquals(new Position3d.Velocity(new Pose3d(1, 2, 3, 4, 5, 6), true), Motions.spatial(c));
    assertTrue(Motions.planar(VelocityCommand.ZERO).motors());
  }
}
