package org.robotui.sim.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class RateTest {
  @Test
  void everyRateIsMetOverAMinute() {
    for (double hertz : new double[]{1, 5, 10, 15, 20, 30, 50, 100}) {
      long count = LongStream.rangeClosed(1, 6000).filter(new Rate(hertz)::isDue).count();
      assertEquals(60 * hertz, count);
    }
  }

  @Test
  void dueStepsAreEvenlySpread() {
    long[] due = LongStream.rangeClosed(1, 1000).filter(new Rate(15)::isDue).toArray();
    for (int i = 1; i < due.length; i++) {
      assertTrue(due[i] - due[i - 1] >= 6 && due[i] - due[i - 1] <= 7);
    }
  }
}
