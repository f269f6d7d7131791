package org.robotui.gl.internal.splat;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class QuadricsTest {
  private static final double[] UP = {0, 0, 1};
  private static final double[] AHEAD = {1, 0, 0};

  @Test
  void theErrorIsTheDistanceFromThePlaneWhateverItsWeight() {
    Quadrics quadrics = new Quadrics(2);
    quadrics.add(1, UP, -2, 0.3);
    assertEquals(0, quadrics.error(1, 5, 6, 2), 1e-9);
    assertEquals(3, quadrics.error(1, 5, 6, -1), 1e-9);
    assertEquals(0, quadrics.error(0, 5, 6, -1), "a place without planes may be anywhere");
  }

  @Test
  void whoIsMergedBringsItsPlanes() {
    Quadrics quadrics = new Quadrics(2);
    quadrics.add(0, UP, 0, 1);
    quadrics.add(1, AHEAD, 0, 1);
    quadrics.merge(0, 1);
    assertEquals(Math.sqrt((9 + 16) / 2.0), quadrics.error(0, 3, 7, 4), 1e-9);
  }
}
