package org.robotui.sim.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class TimetableTest {
  private static final long MILLI = 1_000_000;

  @Test
  void aLateStepDoesNotDelayTheNext() {
    Timetable timetable = new Timetable(0, 1);
    assertEquals(10 * MILLI, timetable.nextDue());
    timetable.stepMade(17 * MILLI);
    assertEquals(20 * MILLI, timetable.nextDue());
  }

  @Test
  void aFactorMakesItFaster() {
    Timetable timetable = new Timetable(0, 3);
    for (int i = 0; i < 299; i++) {
      timetable.stepMade(timetable.nextDue());
    }
    assertEquals(1000 * MILLI, timetable.nextDue());
  }

  @Test
  void afterALongSleepMissedStepsAreLeftOut() {
    Timetable timetable = new Timetable(0, 1);
    timetable.stepMade(60_000 * MILLI);
    assertEquals(60_010 * MILLI, timetable.nextDue());
  }

  @Test
  void nonsenseIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Timetable(0, 0));
    assertThrows(IllegalArgumentException.class, () -> new Timetable(0, Double.NaN));
  }
}
