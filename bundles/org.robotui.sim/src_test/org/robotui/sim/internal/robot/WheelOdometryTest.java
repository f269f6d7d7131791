package org.robotui.sim.internal.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.world.Pose2;

class WheelOdometryTest {
  private static final Wheels WHEELS = new Wheels(0.1, 0.3);

  @Test
  void withoutErrorsItIsTheTruth() {
    WheelOdometry odometry = new WheelOdometry(OdometryErrors.NONE, WHEELS, new Random(1));
    Pose2 truth = drive(odometry, 2000);
    assertEquals(truth.x(), odometry.pose().x(), 1e-9);
    assertEquals(truth.yaw(), odometry.pose().yaw(), 1e-9);
  }

  @Test
  void theDriftIsThereAndBounded() {
    WheelOdometry odometry = new WheelOdometry(OdometryErrors.DEMO, WHEELS, new Random(1));
    Pose2 truth = drive(odometry, 4000);
    double off = truth.distanceTo(odometry.pose());
    assertTrue(off > 0.02, "off by " + off);
    assertTrue(off < 1.5, "off by " + off);
  }

  @Test
  void theSameSeedGivesTheSameErrors() {
    assertEquals(end(7), end(7));
    assertNotEquals(end(7), end(8));
  }

  @Test
  void standingStillNothingDrifts() {
    WheelOdometry odometry = new WheelOdometry(OdometryErrors.DEMO, WHEELS, new Random(1));
    odometry.moved(0, 0);
    assertEquals(Pose2.ORIGIN, odometry.pose());
  }

  @Test
  void wheelsTurnAsFarAsTheyRoll() {
    WheelOdometry odometry = new WheelOdometry(OdometryErrors.NONE, WHEELS, new Random(1));
    odometry.moved(WHEELS.radius(), 0);
    assertEquals(1, odometry.leftAngle(), 1e-9);
    odometry.moved(0, 0.1);
    assertEquals(0.1 * WHEELS.track() / WHEELS.radius(),
        odometry.rightAngle() - odometry.leftAngle(), 1e-9);
  }

  private static Pose2 end(long seed) {
    WheelOdometry odometry = new WheelOdometry(OdometryErrors.DEMO, WHEELS, new Random(seed));
    drive(odometry, 500);
    return odometry.pose();
  }

  /** Twenty metres in 4000 steps, in wide curves. */
  private static Pose2 drive(WheelOdometry odometry, int steps) {
    Pose2 truth = Pose2.ORIGIN;
    for (int i = 0; i < steps; i++) {
      double turn = 0.004 * Math.sin(i / 200.0);
      truth = truth.advance(0.005, turn);
      odometry.moved(0.005, turn);
    }
    return truth;
  }
}
