package org.robotui.uic.trip.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Role;

class TripUicTest {

  private final FakeUicContext context = new FakeUicContext("trip", new TripType().schema());
  private final TripUic uic = new TripUic(context);

  @Test
  void says_why_there_is_nothing_to_show() {
    uic.tick(0);

    assertInstanceOf(InputState.Unconnected.class, uic.state().input());
  }

  @Test
  void adds_up_the_distances_between_poses() {
    go(0, 0);
    go(3, 4);
    go(3, 5);

    assertEquals(6, metres());
  }

  @Test
  void a_new_trip_begins_where_the_robot_is() {
    go(0, 0);
    go(3, 4);
    uic.actions().getFirst().run().run();
    go(3, 5);

    assertEquals(1, metres());
  }

  @Test
  void a_trip_that_is_too_long_is_a_warning() {
    context.settings().set(TripType.LIMIT, 2.0);
    go(0, 0);
    go(3, 4);

    assertEquals(Role.WARNING, uic.state().role(uic.state().trips().getFirst()));
  }

  @Test
  void paints_only_what_is_new() {
    TripPoses.at(context, "odom", 1, 2);

    assertTrue(uic.tick(0));
    assertFalse(uic.tick(1));
  }

  private void go(double x, double y) {
    TripPoses.at(context, "odom", x, y);
    uic.tick(0);
  }

  private double metres() {
    return uic.state().trips().getFirst().metres();
  }
}
