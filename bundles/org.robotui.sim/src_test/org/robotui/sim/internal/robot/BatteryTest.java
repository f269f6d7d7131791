package org.robotui.sim.internal.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class BatteryTest {
  @Test
  void drivingTakesMoreThanStanding() {
    Battery standing = new Battery(0.9);
    Battery driving = new Battery(0.9);
    pass(standing, Speed.ZERO, false, 60);
    pass(driving, new Speed(0.7, 0), false, 60);
    assertTrue(driving.level() < standing.level());
    assertTrue(driving.voltage() < standing.voltage());
    assertTrue(0.9 - driving.level() > 0.01, "a minute of driving is seen: " + driving.level());
  }

  @Test
  void theDockChargesUntilFull() {
    Battery battery = new Battery(0.98);
    pass(battery, Speed.ZERO, true, 30);
    assertTrue(battery.isCharging());
    assertTrue(battery.current() > 0);
    pass(battery, Speed.ZERO, true, 300);
    assertEquals(1, battery.level(), 0.001);
  }

  @Test
  void itEndsEmptyAndNotBelow() {
    Battery battery = new Battery(0.002);
    assertFalse(battery.isEmpty());
    pass(battery, new Speed(0.7, 0), false, 60);
    assertTrue(battery.isEmpty());
    assertEquals(0, battery.level());
  }

  private static void pass(Battery battery, Speed speed, boolean dock, int seconds) {
    for (int i = 0; i < seconds * 100; i++) {
      battery.use(speed, dock, 0.01);
    }
  }
}
