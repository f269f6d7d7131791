package org.robotui.ui.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class EllipseTest {
  @Test
  void axesAreStandardDeviations() {
    Ellipse e = Ellipse.ofCovariance(0.04, 0, 0.01, 2).orElseThrow();
    assertEquals(0.4, e.major(), 1e-9);
    assertEquals(0.2, e.minor(), 1e-9);
    assertEquals(0, e.angle(), 1e-9);
  }

  @Test
  void correlatedPlacesLieAlongTheDiagonal() {
    Ellipse e = Ellipse.ofCovariance(1, 0.5, 1, 1).orElseThrow();
    assertEquals(Math.PI / 4, e.angle(), 1e-9);
    assertEquals(Math.sqrt(1.5), e.major(), 1e-9);
  }

  @Test
  void theOutlineHasItsAxesWhereTheyBelong() {
    double[] xy = new Ellipse(2, 1, Math.PI / 2).outline(10, 20);
    assertEquals(10, xy[0], 1e-9);
    assertEquals(22, xy[1], 1e-9);
  }

  @Test
  void whatIsNoCovarianceGivesNone() {
    assertTrue(Ellipse.ofCovariance(0, 0, 0, 2).isEmpty());
    assertTrue(Ellipse.ofCovariance(Double.NaN, 0, 1, 2).isEmpty());
    assertTrue(Ellipse.ofCovariance(1, 5, 1, 2).isEmpty());
  }
}
