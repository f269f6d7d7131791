package org.robotui.entity.bumper.internal.display;

import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.sensor.Bumper;
import org.robotui.data.sensor.Bumpers;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

/** How bumpers look. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class BumperPicturesTest {
  private static final double RADIUS = 0.3;
  @AutoClose
  private static final ScenePictures PICTURES = new ScenePictures();

  private static Bumper bent(double bearing, boolean pressed) {
    return new Bumper(RigidTransform.planar(RADIUS * Math.cos(bearing), RADIUS * Math.sin(bearing), bearing),
        1.4 * RADIUS, RADIUS, pressed);
  }

  @Test
  void twoAreBentAroundTheFrontOneIsPressedAndAStraightOneLiesBehind() {
    try (DisplayProbe probe = new DisplayProbe(new BumperType())) {
      probe.places().put("base_link", RigidTransform.IDENTITY);
      probe.set("height", 0.08);
      PICTURES.assertLike(BumperPicturesTest.class, "bumpers", ScenePictures.request(
          ScenePictures.withAxes(probe.parts(new Bumpers(
              FakePlaces.frame("base_link"), List.of(bent(0.8, false), bent(-0.8, true),
                  new Bumper(RigidTransform.planar(-RADIUS, 0, Math.PI), 0.4, 0, false)))),
              0.2),
          ScenePictures.eye(new Vector3(-0.5, -0.4, 0.8), new Vector3(0.05, 0, 0))));
    }
  }
}
