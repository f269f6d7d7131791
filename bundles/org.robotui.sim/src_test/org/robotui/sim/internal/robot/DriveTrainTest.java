package org.robotui.sim.internal.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class DriveTrainTest {
  private final DriveTrain drive = new DriveTrain(new DriveLimits(0.6, 1.5, 1.0, 3.0));

  @Test
  void speedGrowsWithTheAllowedAcceleration() {
    assertEquals(0.1, after(10, new Speed(0.6, 0)).linear(), 1e-9);
    assertEquals(0.6, after(100, new Speed(0.6, 0)).linear(), 1e-9);
  }

  @Test
  void wishesBeyondTheLimitsAreCut() {
    Speed speed = after(300, new Speed(-9, 9));
    assertEquals(-0.6, speed.linear(), 1e-9);
    assertEquals(1.5, speed.angular(), 1e-9);
  }

  @Test
  void brakingIsTwiceAsStrong() {
    after(100, new Speed(0.6, 0));
    assertEquals(0.4, after(10, Speed.ZERO).linear(), 1e-9);
  }

  @Test
  void blockingTakesOnlyTheForwardMotion() {
    after(300, new Speed(0.5, 1));
    drive.block();
    assertEquals(new Speed(0, 1), drive.speed());
  }

  private Speed after(int steps, Speed wish) {
    for (int i = 0; i < steps; i++) {
      drive.approach(wish, 0.01);
    }
    return drive.speed();
  }
}
