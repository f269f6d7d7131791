package org.robotui.sim.internal.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.sensor.SatelliteReceiver.Fix;
import org.robotui.sim.internal.world.Pose2;

class SatelliteReceiverTest {
  @Test
  void metresBecomeDegrees() {
    Fix origin = SatelliteReceiver.at(0, 0, 0);
    Fix north = SatelliteReceiver.at(0, 1000, 0);
    Fix east = SatelliteReceiver.at(1000, 0, 0);
    assertEquals(1000 / 111_200.0, north.latitude() - origin.latitude(), 2e-5);
    assertEquals(1000 / (111_320.0 * Math.cos(Math.toRadians(origin.latitude()))),
        east.longitude() - origin.longitude(), 5e-5);
    assertEquals(origin.longitude(), north.longitude());
  }

  @Test
  void theErrorWandersWithinItsDeviation() {
    SatelliteReceiver receiver = new SatelliteReceiver(new Random(1));
    double sum = 0;
    double step = 0;
    Fix truth = SatelliteReceiver.at(3, 4, 0);
    Fix before = receiver.measure(new Pose2(3, 4, 0));
    int count = 20_000;
    for (int i = 0; i < count; i++) {
      Fix fix = receiver.measure(new Pose2(3, 4, 0));
      double error = (fix.latitude() - truth.latitude()) * 111_200;
      sum += error * error;
      step = Math.max(step, Math.abs(fix.latitude() - before.latitude()) * 111_200);
      before = fix;
    }
    assertEquals(SatelliteReceiver.ERROR, Math.sqrt(sum / count), 0.12);
    assertTrue(step < SatelliteReceiver.ERROR, "the largest step is " + step);
  }
}
