package org.robotui.gl.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.data.array.Doubles;

class UncertaintyTest {
  @Test
  void deviationsAreHalfDiameters() {
    Instances ellipsoid = Uncertainty.position(diagonal(4, 9, 0, 0, 0, 0), 1).orElseThrow();
    assertEquals(4, ellipsoid.placings().get(7), 1e-6);
    assertEquals(6, ellipsoid.placings().get(8), 1e-6);
    assertTrue(ellipsoid.placings().get(9) > 0, "seen from the side as well");
  }

  @Test
  void theHeadingOpensToEachSide() {
    double sigma = Math.toRadians(10);
    Instances cone = Uncertainty.heading(diagonal(0, 0, 0, 0, 0, sigma * sigma), 2, 3).orElseThrow();
    assertEquals(3, cone.placings().get(7), 1e-6);
    assertEquals(2 * 3 * Math.tan(2 * sigma), cone.placings().get(8), 1e-5);
  }

  @Test
  void nothingIsDrawnOfNothing() {
    assertTrue(Uncertainty.position(Doubles.EMPTY, 1).isEmpty());
    assertTrue(Uncertainty.position(diagonal(0, 0, 0, 1, 1, 1), 1).isEmpty());
    assertTrue(Uncertainty.position(diagonal(Double.NaN, 1, 1, 0, 0, 0), 1).isEmpty());
    assertTrue(Uncertainty.heading(diagonal(1, 1, 1, 0, 0, 0), 1, 1).isEmpty());
    assertTrue(Uncertainty.heading(diagonal(1, 1, 1, 0, 0, Double.POSITIVE_INFINITY), 1, 1).isEmpty());
    assertTrue(Uncertainty.heading(diagonal(1, 1, 1, 0, 0, 1e30), 1, 1).isPresent());
  }

  private static Doubles diagonal(double... variances) {
    double[] all = new double[36];
    for (int i = 0; i < 6; i++) {
      all[7 * i] = variances[i];
    }
    return Doubles.of(all);
  }
}
