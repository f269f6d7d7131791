package org.robotui.entity.gps;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.GpsFix;

class EarthTest {
  @Test
  void theWayFromFlindersPeakToBuninyongIsAsSurveyed() {
    GeoPoint flinders = GeoPoint.degrees(-(37 + 57 / 60.0 + 3.72030 / 3600), 144 + 25 / 60.0 + 29.52440 / 3600);
    GeoPoint buninyong = GeoPoint.degrees(-(37 + 39 / 60.0 + 10.15610 / 3600), 143 + 55 / 60.0 + 35.38390 / 3600);
    Geodesic way = Geodesic.between(flinders, buninyong);
    // Of the ellipsoid GRS 80, which differs from WGS 84 by a tenth of a millimetre.
    assertEquals(54972.271, way.distance(), 1e-3);
    assertEquals(306 + 52 / 60.0 + 5.37 / 3600, Math.toDegrees(way.bearing()), 1e-5);
  }

  @Test
  void aDegreeOfTheEquatorAndOneOfAMeridianDiffer() {
    assertEquals(111_319.491, Geodesic.between(GeoPoint.degrees(0, 0), GeoPoint.degrees(0, 1)).distance(), 1e-3);
    assertEquals(110_574.389, Geodesic.between(GeoPoint.degrees(0, 0), GeoPoint.degrees(1, 0)).distance(), 1e-3);
    assertEquals(0, Geodesic.between(GeoPoint.degrees(12, 34), GeoPoint.degrees(12, 34)).distance());
    assertEquals(Math.PI / 2, Geodesic.between(GeoPoint.degrees(0, 0), GeoPoint.degrees(0, 1)).bearing(), 1e-12);
  }

  @Test
  void oppositePlacesHaveADistanceToo() {
    double half = Geodesic.between(GeoPoint.degrees(0, 0), GeoPoint.degrees(0.1, 179.9)).distance();
    assertEquals(20_004_000, half, 120_000);
    assertEquals(20_003_931, Geodesic.between(GeoPoint.degrees(90, 0), GeoPoint.degrees(-90, 0)).distance(), 60_000);
  }

  @ParameterizedTest
  @CsvSource({"42.375812, -71.147395", "0, 0", "0, 180", "-17.8, 179.9999", "89.9999, 20", "-89.9999, -130", "90, 0",
      "-90, 0"})
  void thePlaneIsTrueNearItsOrigin(double latitude, double longitude) {
    GeoPoint origin = GeoPoint.degrees(latitude, longitude);
    LocalPlane plane = new LocalPlane(origin);
    assertEquals(new LocalPlane.Point(0, 0), round(plane.point(origin).orElseThrow()));
    for (double[] at : new double[][]{{100, 0}, {0, 250}, {-3000, 4000}, {7000, -7000}}) {
      GeoPoint place = plane.place(at[0], at[1]).orElseThrow();
      LocalPlane.Point again = plane.point(place).orElseThrow();
      assertEquals(at[0], again.east(), 1e-6);
      assertEquals(at[1], again.north(), 1e-6);
      double distance = Math.hypot(at[0], at[1]);
      assertEquals(distance, Geodesic.between(origin, place).distance(), 2e-5 + 1e-14 * Math.pow(distance, 3));
    }
  }

  @Test
  void farFromItsOriginThePlaneStillGoesThereAndBack() {
    LocalPlane plane = new LocalPlane(GeoPoint.degrees(51, 7));
    LocalPlane.Point again = plane.point(plane.place(300_000, -200_000).orElseThrow()).orElseThrow();
    assertEquals(300_000, again.east(), 1e-4);
    assertEquals(-200_000, again.north(), 1e-4);
    assertTrue(plane.point(GeoPoint.degrees(-33, 151)).isEmpty());
    assertTrue(plane.place(1e7, 0).isEmpty());
    assertTrue(plane.place(Double.NaN, 0).isEmpty());
  }

  @Test
  void theAntimeridianIsNoEdge() {
    LocalPlane plane = new LocalPlane(GeoPoint.degrees(-17, 179.999));
    double east = plane.point(GeoPoint.degrees(-17, -179.999)).orElseThrow().east();
    assertEquals(213, east, 1);
    assertEquals(Math.toRadians(-179.5), new GeoPoint(0, Math.toRadians(180.5)).longitude(), 1e-12);
    assertEquals(Math.PI, new GeoPoint(0, -Math.PI).longitude());
    assertEquals(213, Geodesic.between(GeoPoint.degrees(-17, 179.999), GeoPoint.degrees(-17, -179.999)).distance(), 1);
  }

  @Test
  void whatIsNoPlaceIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> GeoPoint.degrees(91, 0));
    assertThrows(IllegalArgumentException.class, () -> GeoPoint.degrees(Double.NaN, 0));
    FrameId frame = new FrameId("Keira", "gps");
    assertTrue(GeoPoint.of(new GpsFix(frame, GpsFix.Quality.NO_FIX, 0, 0, 0, 1)).isEmpty());
    assertTrue(GeoPoint.of(new GpsFix(frame, GpsFix.Quality.FIX, Double.NaN, 0, 0, 1)).isEmpty());
  }

  @Test
  void placesAreReadAndCopied() {
    GeoPoint place = GeoPoint.degrees(42.375812, -71.14739466666667);
    assertEquals("42.375812\u00b0\u00a0N  71.147395\u00b0\u00a0W", GeoText.decimal(place));
    assertEquals("42\u00b022\u203232.92\u2033\u00a0N  071\u00b008\u203250.62\u2033\u00a0W", GeoText.sexagesimal(place));
    assertEquals("42.3758120, -71.1473947", GeoText.plain(place));
    assertEquals("00\u00b001\u203200.00\u2033\u00a0S  001\u00b000\u203200.00\u2033\u00a0E",
        GeoText.sexagesimal(GeoPoint.degrees(-59.9999 / 3600, 3599.999 / 3600)), "no 60 seconds");
    assertEquals("045.0\u00b0", GeoText.bearing(Math.PI / 4));
    assertEquals("000.0\u00b0", GeoText.bearing(Math.toRadians(359.99)));
    assertEquals("3.412\u00a0km", GeoText.distance(3412));
  }

  private static LocalPlane.Point round(LocalPlane.Point p) {
    return new LocalPlane.Point(Math.abs(Math.round(p.east() * 1e6) / 1e6),
        Math.abs(Math.round(p.north() * 1e6) / 1e6));
  }
}
