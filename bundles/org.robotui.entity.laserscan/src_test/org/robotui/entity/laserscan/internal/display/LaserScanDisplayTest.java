package org.robotui.entity.laserscan.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.data.array.Floats;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.PointSet;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

class LaserScanDisplayTest {
  private final DisplayProbe probe = new DisplayProbe(new LaserScanType());

  @BeforeEach
  void placeTheScanner() {
    probe.places().put("laser", RigidTransform.planar(1, 0, 0));
  }

  @Test
  void echoesAreShownAndNothingElse() {
    Part part = probe.parts(scan(1, Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, -3, 99, 2)).getFirst();
    PointSet points = (PointSet) part.shape();
    assertEquals(2, points.elements());
    assertEquals(1, points.xyz().get(0), 1e-6);
    assertEquals(2 * Math.sin(0.6), points.xyz().get(4), 1e-6);
    assertEquals(1, part.fixedFromShape().translation().x());
    assertEquals("2 echoes", probe.tick().status().words());
  }

  @Test
  void theSameShapeStaysWhileNothingChanged() {
    Object first = probe.parts(scan(1, 2)).getFirst().shape();
    assertSame(first, probe.parts().getFirst().shape());
  }

  @Test
  void neighboursAreJoinedWhereTheyAreNear() {
    probe.set("style", "both");
    assertEquals(2, probe.parts(scan(1, 1, 1, 5, Float.NaN, 5)).get(1).shape().elements());
    probe.set("style", "lines").set("gap", 100.0);
    assertEquals(3, probe.parts().getFirst().shape().elements());
  }

  @Test
  void rangeAndIntensityColour() {
    probe.set("color_by", "range");
    PointSet points = (PointSet) probe.parts(scan(1, 2)).getFirst().shape();
    assertNotEquals(points.rgba().orElseThrow().getInt(0), points.rgba().orElseThrow().getInt(4));
    DisplayResult without = probe.set("color_by", "intensity").tick();
    assertInstanceOf(DisplayStatus.Partly.class, without.status());
    assertTrue(((PointSet) without.parts().getFirst().shape()).rgba().isEmpty());
    LaserScan strong =
        new LaserScan(FakePlaces.frame("laser"), 0, 0.1, 0, 10, 0, Floats.of(1, 2), Floats.of(Float.NaN, 5));
    assertInstanceOf(DisplayStatus.Shown.class, probe.tick(strong).status());
  }

  @Test
  void scansOfTheLastSecondsStayWhereTheyWere() {
    probe.set("decay", 0.25).tick(scan(1));
    probe.places().put("laser", RigidTransform.planar(2, 0, 0));
    assertEquals(2, probe.parts(scan(1)).size());
    probe.tick();
    probe.tick();
    assertEquals(1, probe.tick().parts().size());
    probe.reset();
    assertInstanceOf(DisplayStatus.NoData.class, probe.tick().status());
  }

  @Test
  void anEmptyScanAndAFullOneAreShown() {
    assertEquals(0, probe.set("style", "both").parts(scan()).getFirst().shape().elements());
    float[] many = new float[100_000];
    Arrays.fill(many, 3);
    assertEquals(100_000, probe.parts(scan(many)).getFirst().shape().elements());
  }

  @Test
  void aSelectedEchoSaysItsDistanceAndAngle() {
    Part part = probe.parts(scan(Float.NaN, 2)).getFirst();
    String text = part.describer().describe(0, Vector3.ZERO).toString();
    assertTrue(text.contains("2.000 m") && text.contains("5.7\u00b0") && text.contains("beam 1"), text);
    assertEquals("laser scan", part.describer().describe(7, Vector3.ZERO).title());
    probe.close();
  }

  private static LaserScan scan(float... ranges) {
    return new LaserScan(FakePlaces.frame("laser"), 0, 0.1, 0, 10, 0, Floats.of(ranges), Floats.EMPTY);
  }
}
