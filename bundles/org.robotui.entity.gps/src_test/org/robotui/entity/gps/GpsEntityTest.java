package org.robotui.entity.gps;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.GpsFix;
import org.robotui.ui.scene.Bounds;

class GpsEntityTest {
  private static final long FOREVER = Long.MAX_VALUE / 4;
  private static final GeoPoint ORIGIN = GeoPoint.degrees(42, -71);
  private static final LocalPlane PLANE = new LocalPlane(ORIGIN);

  private final GpsEntity entity = new GpsEntity(0);

  @Test
  void aTrackOfHoursIsBoundedAndStaysWhole() {
    Track track = new Track(100);
    for (int i = 0; i < 50_000; i++) {
      add(track, i * 0.2, 0, GpsFix.Quality.FIX, i);
    }
    assertTrue(track.count() <= 100 && track.count() > 40, "kept " + track.count());
    assertEquals(0, track.points()[0], 0.5);
    assertEquals(10_000, track.points()[2 * track.count() - 2], 400);
  }

  @Test
  void aReceiverAtRestAddsNothing() {
    Track track = new Track(100);
    for (int i = 0; i < 1000; i++) {
      add(track, 0.03 * Math.sin(i), 0, GpsFix.Quality.FIX, i);
    }
    assertEquals(1, track.count());
    add(track, 0, 0, GpsFix.Quality.GROUND_AUGMENTED, 1001);
    assertEquals(2, track.count(), "but a change of quality does");
  }

  @Test
  void theOldIsForgotten() {
    Track track = new Track(100);
    for (int i = 0; i < 10; i++) {
      add(track, i, 0, GpsFix.Quality.FIX, 100 * i);
    }
    track.forgetBefore(500);
    assertEquals(5, track.count());
    assertEquals(5, track.points()[0], 1e-6);
  }

  @Test
  void aReceiverWithoutFixStaysWhereItWas() {
    entity.prepare(fix(GpsFix.Quality.FIX, 30, 40), PLANE, 0, FOREVER);
    entity.prepare(
        new GpsFix(new FrameId("Keira", "gps"), GpsFix.Quality.NO_FIX, Double.NaN, Double.NaN, 0, Double.NaN), PLANE, 1,
        FOREVER);
    assertTrue(entity.describeAt(30, 40, 1).orElseThrow().text().startsWith("no fix"));
    assertTrue(entity.describeAt(33, 40, 1).isEmpty());
  }

  @Test
  void anotherOriginMovesTheWholeWay() {
    entity.prepare(fix(GpsFix.Quality.FIX, 0, 0), PLANE, 0, FOREVER);
    entity.prepare(fix(GpsFix.Quality.FIX, 100, 0), PLANE, 1, FOREVER);
    LocalPlane other = new LocalPlane(PLANE.place(100, 0).orElseThrow());
    entity.prepare(fix(GpsFix.Quality.FIX, 100, 0), other, 2, FOREVER);
    Bounds bounds = entity.bounds().orElseThrow();
    assertEquals(-100, bounds.minX(), 0.01);
    assertEquals(1, bounds.maxX(), 0.01);
  }

  @Test
  void whatIsOutOfReachIsNotDrawn() {
    entity.prepare(fix(GpsFix.Quality.FIX, 0, 0), new LocalPlane(GeoPoint.degrees(-42, 109)), 0, FOREVER);
    assertTrue(entity.bounds().isEmpty());
  }

  @Test
  void theWayIsClearedNotThePlace() {
    entity.prepare(fix(GpsFix.Quality.FIX, 0, 0), PLANE, 0, FOREVER);
    entity.prepare(fix(GpsFix.Quality.FIX, 100, 0), PLANE, 1, FOREVER);
    entity.clear();
    assertEquals(99, entity.bounds().orElseThrow().minX(), 0.01);
  }

  private static void add(Track track, double east, double north, GpsFix.Quality quality, long now) {
    track.add(ORIGIN, new LocalPlane.Point(east, north), quality, now);
  }

  private static GpsFix fix(GpsFix.Quality quality, double east, double north) {
    GeoPoint place = PLANE.place(east, north).orElseThrow();
    return new GpsFix(new FrameId("Keira", "gps"), quality, place.latitude(), place.longitude(), 10, 0.9);
  }
}
