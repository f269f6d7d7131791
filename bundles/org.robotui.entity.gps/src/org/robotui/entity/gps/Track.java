package org.robotui.entity.gps;

import java.util.Arrays;
import java.util.Optional;
import org.robotui.data.sensor.GpsFix;
import org.robotui.ui.scene.PositionHistory;

/**
 * Where a receiver has been: a way of which each place has its time and quality. The places are kept, so that they can
 * be put on another plane. Not safe for several threads.
 */
final class Track {
  private static final double FINEST = 0.1;

  private final PositionHistory way;
  private final GeoPoint[] places;
  private final long[] nanos;
  private final byte[] qualities;

  Track(int capacity) {
    way = new PositionHistory(capacity, FINEST, this::move);
    places = new GeoPoint[capacity];
    nanos = new long[capacity];
    qualities = new byte[capacity];
  }

  void add(GeoPoint place, LocalPlane.Point point, GpsFix.Quality quality, long now) {
    boolean same = way.near(point.east(), point.north()) && quality.ordinal() == qualities[way.count() - 1];
    if (!same) {
      int at = way.add(point.east(), point.north());
      places[at] = place;
      qualities[at] = (byte) quality.ordinal();
      nanos[at] = now;
    }
  }

  /** Forgets what is older than a time. */
  void forgetBefore(long time) {
    int first = 0;
    while (first < way.count() && nanos[first] - time < 0) {
      first++;
    }
    way.forget(first);
  }

  /** Puts all places on another plane; those out of its reach go. */
  void replace(LocalPlane plane) {
    int kept = 0;
    for (int i = 0; i < way.count(); i++) {
      Optional<LocalPlane.Point> point = plane.point(places[i]);
      if (point.isPresent()) {
        move(i, kept, 1);
        way.set(kept++, point.get().east(), point.get().north());
      }
    }
    way.keep(kept);
  }

  void clear() {
    way.clear();
  }

  int count() {
    return way.count();
  }

  /** East and north in turn; a copy. */
  double[] points() {
    return way.points();
  }

  /** The ordinals of the qualities; a copy. */
  byte[] qualities() {
    return Arrays.copyOf(qualities, way.count());
  }

  private void move(int from, int to, int count) {
    System.arraycopy(places, from, places, to, count);
    System.arraycopy(nanos, from, nanos, to, count);
    System.arraycopy(qualities, from, qualities, to, count);
  }
}
