package org.robotui.sim.internal.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.robot.Speed;

class ImuTest {
  @Test
  void headingFollowsTheTurnRate() {
    Imu imu = new Imu(new Random(1));
    for (int i = 0; i < 200; i++) {
      imu.update(new Speed(0.5, 0.5), 0.01);
    }
    assertEquals(1.0, imu.heading(), 0.02);
    assertEquals(0.25, imu.sideways(), 0.15);
  }

  @Test
  void speedingUpIsFelt() {
    Imu imu = new Imu(new Random(1));
    imu.update(new Speed(0.01, 0), 0.01);
    assertEquals(1.0, imu.forward(), 0.15);
  }
}
