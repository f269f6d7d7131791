package org.robotui.entity.grid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GridStepsTest {
  @Test
  void stepsAreOneTwoOrFive() {
    assertEquals(1, GridSteps.atLeast(60, 44), 1e-9);
    assertEquals(2, GridSteps.atLeast(60, 80), 1e-9);
    assertEquals(5, GridSteps.atLeast(10, 44), 1e-9);
    assertEquals(0.01, GridSteps.atLeast(4400, 44), 1e-12);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.01, 0.37, 3.3, 51, 777, 10_000})
  void stepsAreLongEnoughAndNotMuchLonger(double scale) {
    double pixels = GridSteps.atLeast(scale, 44) * scale;
    assertTrue(pixels >= 44 - 1e-6 && pixels <= 44 * 2.5 + 1e-6, () -> pixels + " px at " + scale);
  }

  @Test
  void linesAreBoundedWhateverIsSeen() {
    assertArrayEquals(new double[]{-2, 0, 2}, GridSteps.within(-3, 3, 2));
    double[] starts = {0, -0.0, 5e31, -1e300, Double.MAX_VALUE, Double.NaN, Double.NEGATIVE_INFINITY};
    for (double low : starts) {
      for (double high : new double[]{low, low + 1e5, 1e300, Double.POSITIVE_INFINITY, Double.NaN}) {
        for (double step : new double[]{0, 1e-320, 1e-9, 5000, 1e300, Double.NaN, Double.POSITIVE_INFINITY}) {
          assertTrue(GridSteps.within(low, high, step).length <= 1000);
        }
      }
    }
  }

  @Test
  void labelsTakeTheUnitThatNeedsNoDecimals() {
    assertEquals("2\u00a0m", GridSteps.label(2));
    assertEquals("50\u00a0cm", GridSteps.label(0.5));
    assertEquals("5\u00a0mm", GridSteps.label(0.005));
    assertEquals("2\u00a0km", GridSteps.label(2000));
  }
}
