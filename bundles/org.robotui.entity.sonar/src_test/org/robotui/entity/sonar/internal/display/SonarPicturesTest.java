package org.robotui.entity.sonar.internal.display;

import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

/** How cones look. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class SonarPicturesTest {
  @AutoClose
  private static final ScenePictures PICTURES = new ScenePictures();

  private static RangeReading reading(String frame, RangeReading.Kind kind, double opening, double range) {
    return new RangeReading(FakePlaces.frame(frame), kind, opening, 0.1, 2, range);
  }

  @Test
  void conesReachFromTheSensorToTheEchoAndFaintOnesToTheLimit() {
    try (DisplayProbe probe = new DisplayProbe(new SonarType())) {
      probe.places().put("left", RigidTransform.planar(0.2, 0.3, Math.PI / 4));
      probe.places().put("front", RigidTransform.planar(0.3, 0, 0));
      probe.places().put("right", RigidTransform.planar(0.2, -0.3, -Math.PI / 4));
      probe.set("opacity", 0.5);
      PICTURES.assertLike(SonarPicturesTest.class, "cones",
          ScenePictures.request(ScenePictures.withAxes(probe.parts(new RangeReadings(List.of(
              reading("left", RangeReading.Kind.ULTRASOUND, 0.5, 1),
              reading("front", RangeReading.Kind.INFRARED, 0.1, 1.5),
              reading("right", RangeReading.Kind.ULTRASOUND, 0.5, Double.POSITIVE_INFINITY)))), 0.5),
              ScenePictures.eye(new Vector3(-0.8, 0, 1.9), new Vector3(0.8, -0.2, 0))));
    }
  }
}
