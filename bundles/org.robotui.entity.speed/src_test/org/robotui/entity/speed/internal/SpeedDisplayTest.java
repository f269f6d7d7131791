package org.robotui.entity.speed.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Box3;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

class SpeedDisplayTest {

  private final DisplayProbe probe = new DisplayProbe(new SpeedType());

  @BeforeEach
  void theRobotIsSomewhere() {
    probe.places().put("base", RigidTransform.planar(5, 0, 0));
  }

  @AfterEach
  void end() {
    probe.close();
  }

  @Test
  void the_arrow_points_where_the_robot_goes_and_is_as_long_as_it_is_fast() {
    Box3 arrow =
        probe.set(SpeedType.SCALE, 2.0).tick(going(new Vector3(0, 1.5, 0))).parts().getFirst().bounds().orElseThrow();

    assertEquals(3, arrow.high().y(), 1e-3);
    assertEquals(5, arrow.center().x(), 1e-3);
  }

  @Test
  void a_robot_that_stands_has_no_arrow() {
    DisplayResult result = probe.tick(going(Vector3.ZERO));

    assertEquals(List.of(), result.parts());
    assertEquals(new DisplayStatus.Shown("0.00 m/s"), result.status());
  }

  @Test
  void without_a_place_the_status_says_why_nothing_is_drawn() {
    Odometry elsewhere =
        new Odometry(FakePlaces.frame("odom"), FakePlaces.frame("arm"), RigidTransform.IDENTITY, Doubles.EMPTY,
            new Vector3(1, 0, 0), Vector3.ZERO, Doubles.EMPTY);

    assertInstanceOf(DisplayStatus.NoFrame.class, probe.tick(elsewhere).status());
  }

  private static Odometry going(Vector3 speed) {
    return new Odometry(FakePlaces.frame("odom"), FakePlaces.frame("base"), RigidTransform.IDENTITY, Doubles.EMPTY,
        speed, Vector3.ZERO,
        Doubles.EMPTY);
  }
}
