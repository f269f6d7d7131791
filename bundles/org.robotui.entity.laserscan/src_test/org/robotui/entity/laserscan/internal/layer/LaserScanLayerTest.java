package org.robotui.entity.laserscan.internal.layer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.data.array.Floats;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.values.layer.LayerProbe;
import org.robotui.ui.layer.LayerStatus;

class LaserScanLayerTest {
  private final LayerProbe probe = new LayerProbe(new LaserScanLayerType());
  private final LaserScan scan =
      new LaserScan(LayerProbe.frame("laser"), 0, 1, 0, 10, 0.1, Floats.of(2f, 3f), Floats.EMPTY);

  @Test
  void aScanThatNobodyCanPlaceWaitsForItsTransform() {
    LayerStatus status = probe.tick(scan).status();
    assertInstanceOf(LayerStatus.NoFrame.class, status);
    assertTrue(status.words().startsWith("no transform map \u2190 laser: "), status.words());
    probe.put("laser", RigidTransform.planar(1, 0, 0));
    assertTrue(probe.tick().changed());
    assertTrue(probe.layer().describeAt(3, 0, 0.01).isPresent());
  }

  @Test
  void nothingNewMeansNothingToPaint() {
    probe.put("laser", RigidTransform.IDENTITY);
    assertEquals("2 echoes", probe.tick(scan).status().words());
    assertFalse(probe.tick().changed());
    probe.set("color", "#123456");
    assertTrue(probe.tick().changed());
  }
}
