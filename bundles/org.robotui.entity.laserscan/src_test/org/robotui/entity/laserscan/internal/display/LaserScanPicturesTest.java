package org.robotui.entity.laserscan.internal.display;

import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.array.Floats;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

/** How scans look. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class LaserScanPicturesTest {
  @AutoClose
  private static final ScenePictures PICTURES = new ScenePictures();

  private static final int BEAMS = 181;
  private static final Eye EYE = ScenePictures.eye(new Vector3(0, 0, 3.6), new Vector3(1.5, 0, 0));

  private final DisplayProbe probe = new DisplayProbe(new LaserScanType());

  LaserScanPicturesTest() {
    probe.places().put("laser", RigidTransform.planar(0.5, 0, 0));
  }

  /**
   * A wall 3 m ahead from right to left (beam 0 is at the right), nothing between 20 and 40 degrees at the left;
   * stronger to the left.
   */
  private static LaserScan wall() {
    float[] ranges = new float[BEAMS];
    float[] intensities = new float[BEAMS];
    for (int i = 0; i < BEAMS; i++) {
      double angle = Math.toRadians(i - 90.0);
      double ahead = 2.5 / Math.max(Math.cos(angle), 1e-3);
      double aside = 2 / Math.max(Math.abs(Math.sin(angle)), 1e-3);
      ranges[i] = i > 110 && i < 130 ? Float.POSITIVE_INFINITY : (float) Math.min(ahead, aside);
      intensities[i] = i;
    }
    return new LaserScan(FakePlaces.frame("laser"), -Math.PI / 2, Math.PI / 180, 0.1, 10, 0.1, Floats.of(ranges),
        Floats.of(intensities));
  }

  private void show(String name) {
    PICTURES.assertLike(LaserScanPicturesTest.class, name,
        ScenePictures.request(ScenePictures.withAxes(probe.parts(), 0.5), EYE));
    probe.close();
  }

  @Test
  void echoesLieAroundTheScanner() {
    probe.tick(wall());
    show("flat");
  }

  @Test
  void rangesColour() {
    probe.set("color_by", "range").set("style", "both").set("unit", "metres").set("size", 0.08).tick(wall());
    show("range");
  }

  @Test
  void intensitiesColourFromTheRightToTheLeft() {
    probe.set("color_by", "intensity").set("size", 6.0).tick(wall());
    show("intensity");
  }

  @Test
  void scansOfTheLastSecondsLieWhereTheyWereMeasured() {
    probe.set("decay", 10.0).set("style", "lines");
    for (int i = 0; i < 4; i++) {
      probe.places().put("laser", RigidTransform.planar(0.3 * i, 0, 0.1 * i));
      probe.tick(wall());
    }
    show("decay");
  }
}
