package org.robotui.uic.gps.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.entity.gps.GeoPoint;

class RulerTest {
  private final Ruler ruler = new Ruler();

  @Test
  void twoClicksMeasureDistanceAndBearing() {
    ruler.move(GeoPoint.degrees(1, 1));
    assertTrue(ruler.measure().isEmpty());
    ruler.click(GeoPoint.degrees(0, 0));
    ruler.move(GeoPoint.degrees(0, 2));
    assertEquals(222_639, ruler.measure().orElseThrow().distance(), 1, "it goes with the pointer");
    ruler.click(GeoPoint.degrees(0, 1));
    ruler.move(GeoPoint.degrees(5, 5));
    assertEquals(111_319, ruler.measure().orElseThrow().distance(), 1, "the end is set");
    assertEquals(Math.PI / 2, ruler.measure().orElseThrow().bearing(), 1e-9);
    ruler.click(GeoPoint.degrees(3, 3));
    assertTrue(ruler.measure().isEmpty(), "a third click begins anew");
  }
}
