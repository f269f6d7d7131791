package org.robotui.entity.reach.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.testkit.values.layer.LayerProbe;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.scene.Bounds;

class ReachTest {

  private final LayerProbe probe = new LayerProbe(new ReachType());

  @Test
  void a_robot_that_goes_straight_reaches_what_lies_ahead() {
    probe.put("base", RigidTransform.planar(1, 0, Math.PI / 2)).set(ReachType.SECONDS, 4.0).tick(going(0.5, 0));

    Bounds bounds = probe.layer().bounds().orElseThrow();
    assertEquals(2, bounds.maxY(), 1e-9);
    assertEquals(1, bounds.maxX(), 1e-9);
    assertTrue(probe.layer().describeAt(1, 2, 0.01).isPresent());
    assertFalse(probe.layer().describeAt(1, 3, 0.01).isPresent());
  }

  @Test
  void a_robot_that_turns_goes_round_a_circle() {
    probe.put("base", RigidTransform.IDENTITY).set(ReachType.SECONDS, Math.PI).tick(going(1, 1));

    assertEquals(2, probe.layer().bounds().orElseThrow().maxY(), 0.01);
  }

  @Test
  void without_a_place_it_says_what_is_missing() {
    assertInstanceOf(LayerStatus.NoFrame.class, probe.tick(going(1, 0)).status());
  }

  @Test
  @EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
  void it_is_painted_in_the_colour_of_the_list() {
    probe.put("base", RigidTransform.IDENTITY).set("color", "#ff0000").tick(going(1, 0));

    assertEquals(0xff, probe.picture(TestDisplay.get(), 100, 100).getPixel(60, 50) >> 16 & 0xff);
  }

  private static Odometry going(double forward, double turning) {
    return new Odometry(LayerProbe.frame("odom"), LayerProbe.frame("base"), RigidTransform.IDENTITY, Doubles.EMPTY,
        new Vector3(forward, 0, 0), new Vector3(0, 0, turning), Doubles.EMPTY);
  }
}
