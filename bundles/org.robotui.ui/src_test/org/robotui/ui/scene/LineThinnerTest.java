package org.robotui.ui.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class LineThinnerTest {
  private static final double TOLERANCE = 0.25;

  private static double[] thinned(double... xy) {
    double[] copy = xy.clone();
    return Arrays.copyOf(copy, 2 * LineThinner.thin(copy, copy.length / 2, TOLERANCE));
  }

  @Test
  void ofAStraightLineItsEndsAreLeft() {
    assertArrayEquals(new double[]{0, 0, 9, 3}, thinned(0, 0, 3, 1, 6, 2.1, 9, 3));
  }

  @Test
  void cornersAreKept() {
    assertArrayEquals(new double[]{0, 0, 10, 0, 10, 10}, thinned(0, 0, 5, 0, 10, 0, 10, 5, 10, 10));
  }

  @Test
  void aWayThereAndBackIsAsLongAsItWas() {
    assertArrayEquals(new double[]{0, 0, 10, 0, 4, 0}, thinned(0, 0, 5, 0, 10, 0, 7, 0, 4, 0));
  }

  @Test
  void oneThatStandsStaysAPoint() {
    assertArrayEquals(new double[]{1, 1, 1, 1}, thinned(1, 1, 1, 1, 1, 1, 1, 1));
    assertArrayEquals(new double[]{1, 1, 2, 2}, thinned(1, 1, 2, 2));
  }

  @Test
  void noPointIsFartherFromTheLineThanAllowedAndMostAreLeftOut() {
    for (int seed = 0; seed < 50; seed++) {
      double[] way = driven(new Random(seed));
      double[] left = thinned(way);
      assertTrue(left.length < way.length / 4, "of " + way.length + " are left " + left.length);
      for (int i = 0; i < way.length; i += 2) {
        assertEquals(0, distance(left, way[i], way[i + 1]), TOLERANCE + 1e-9);
      }
    }
  }

  private static double[] driven(Random random) {
    double[] way = new double[4000];
    double heading = 0;
    double turn = 0;
    for (int i = 1; i < way.length / 2; i++) {
      turn = random.nextInt(40) == 0 ? random.nextDouble(-0.1, 0.1) : turn;
      heading += turn;
      way[2 * i] = way[2 * i - 2] + 0.8 * Math.cos(heading);
      way[2 * i + 1] = way[2 * i - 1] + 0.8 * Math.sin(heading);
    }
    return way;
  }

  private static double distance(double[] line, double x, double y) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 2; i < line.length; i += 2) {
      double dx = line[i] - line[i - 2];
      double dy = line[i + 1] - line[i - 1];
      double length = Math.max(1e-12, dx * dx + dy * dy);
      double along = Math.clamp(((x - line[i - 2]) * dx + (y - line[i - 1]) * dy) / length, 0.0, 1.0);
      nearest = Math.min(nearest, Math.hypot(line[i - 2] + along * dx - x, line[i - 1] + along * dy - y));
    }
    return nearest;
  }
}
