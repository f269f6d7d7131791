package org.robotui.gl.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.Vector3;

class EllipsoidTest {
  @Test
  void theAxesAndDeviationsMakeTheCovarianceAgain() {
    Random random = new Random(7);
    for (int round = 0; round < 200; round++) {
      Quaternion turn =
          Quaternion.fromRollPitchYaw(random.nextDouble(-3, 3), random.nextDouble(-1.5, 1.5), random.nextDouble(-3, 3));
      double[][] c =
          covariance(turn, new Vector3(random.nextDouble(0, 4), random.nextDouble(0, 4), random.nextDouble(0, 4)));
      Ellipsoid found = Ellipsoid.of(c[0][0], c[0][1], c[0][2], c[1][1], c[1][2], c[2][2]).orElseThrow();
      double[][] again = covariance(found.rotation(), found.deviations());
      for (int i = 0; i < 9; i++) {
        assertEquals(c[i / 3][i % 3], again[i / 3][i % 3], 1e-9);
      }
    }
  }

  @Test
  void noCovarianceIsAPoint() {
    assertEquals(new Ellipsoid(Quaternion.IDENTITY, Vector3.ZERO), Ellipsoid.of(0, 0, 0, 0, 0, 0).orElseThrow());
    assertEquals(Vector3.ZERO, Ellipsoid.of(-1, 0, 0, -4, 0, -1e300).orElseThrow().deviations());
  }

  @Test
  void whatIsNotFiniteHasNone() {
    assertTrue(Ellipsoid.of(Double.NaN, 0, 0, 1, 0, 1).isEmpty());
    assertTrue(Ellipsoid.of(1, Double.POSITIVE_INFINITY, 0, 1, 0, 1).isEmpty());
  }

  @Test
  void hugeAndTinyNumbersEnd() {
    Ellipsoid.of(1e300, 1e299, -1e298, 1e-300, 1, 1e300).ifPresent(e -> assertTrue(e.deviations().isFinite()));
    Ellipsoid.of(1e-320, 1e-321, 0, 1e-322, 0, 1).ifPresent(e -> assertEquals(1, e.rotation().norm(), 1e-9));
  }

  private static double[][] covariance(Quaternion turn, Vector3 deviations) {
    Vector3[] axes =
        {turn.rotate(new Vector3(1, 0, 0)), turn.rotate(new Vector3(0, 1, 0)), turn.rotate(new Vector3(0, 0, 1))};
    double[] variances =
        {deviations.x() * deviations.x(), deviations.y() * deviations.y(), deviations.z() * deviations.z()};
    double[][] sum = new double[3][3];
    for (int k = 0; k < 3; k++) {
      double[] a = {axes[k].x(), axes[k].y(), axes[k].z()};
      for (int i = 0; i < 9; i++) {
        sum[i / 3][i % 3] += variances[k] * a[i / 3] * a[i % 3];
      }
    }
    return sum;
  }
}
