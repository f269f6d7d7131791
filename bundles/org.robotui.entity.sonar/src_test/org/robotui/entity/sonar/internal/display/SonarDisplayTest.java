package org.robotui.entity.sonar.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

class SonarDisplayTest {
  private final DisplayProbe probe = new DisplayProbe(new SonarType());

  @BeforeEach
  void placeTheSensors() {
    probe.places().put("left", RigidTransform.planar(0, 1, Math.PI / 2));
    probe.places().put("right", RigidTransform.planar(0, -1, -Math.PI / 2));
  }

  @Test
  void aConeReachesFromItsSensorToTheEcho() {
    Part part = probe.parts(readings("left", 2)).getFirst();
    assertEquals(1, part.fixedFromShape().translation().y());
    assertEquals(2, ((Instances) part.shape()).placings().get(7), 1e-6);
    assertEquals("sonar left", part.describer().describe(0, Vector3.ZERO).title());
  }

  @Test
  void theNewestOfEachSensorStaysTheSameObject() {
    Object left = probe.parts(readings("left", 2)).getFirst().shape();
    List<Part> both = probe.parts(readings("right", 1));
    assertEquals(2, both.size());
    assertSame(left, both.getFirst().shape());
    assertSame(left, probe.parts(readings("left", 2)).getFirst().shape());
  }

  @Test
  void withoutAnEchoTheConeIsFaintOrHidden() {
    float faint = probe.parts(readings("left", Double.POSITIVE_INFINITY)).getFirst().material().color().alpha();
    assertTrue(faint < probe.parts(readings("left", 1)).getFirst().material().color().alpha());
    probe.set("free", false).tick(readings("left", 99));
    assertTrue(probe.parts().isEmpty());
  }

  @Test
  void whatSaysNothingIsNotShown() {
    for (double range : new double[]{Double.NaN, Double.NEGATIVE_INFINITY, -1, 0.01}) {
      assertTrue(probe.parts(readings("left", range)).isEmpty(), "" + range);
    }
    assertEquals("0 of 1 sensors", probe.tick().status().words());
  }

  @Test
  void anUnknownFrameIsNamed() {
    assertInstanceOf(DisplayStatus.NoFrame.class, probe.tick(readings("lost", 1)).status());
    DisplayResult result = probe.tick(readings("left", 1));
    assertInstanceOf(DisplayStatus.Partly.class, result.status());
    assertTrue(result.status().words().contains("lost"));
  }

  @Test
  void sensorsAreBoundedAndReadingsForgotten() {
    Stream<RangeReading> many = IntStream.range(0, 1500).mapToObj(i -> reading("s" + i, 1));
    assertEquals(500, probe.tick(new RangeReadings(many.toList())).dropped());
    assertInstanceOf(DisplayStatus.NoData.class, probe.reset().status());
    probe.state(new InputState.Waiting("no reading yet"));
    assertEquals("no reading yet", probe.tick().status().words());
    probe.close();
  }

  private static RangeReadings readings(String frame, double range) {
    return new RangeReadings(List.of(reading(frame, range)));
  }

  private static RangeReading reading(String frame, double range) {
    return new RangeReading(FakePlaces.frame(frame), RangeReading.Kind.ULTRASOUND, 0.5, 0.1, 4, range);
  }
}
