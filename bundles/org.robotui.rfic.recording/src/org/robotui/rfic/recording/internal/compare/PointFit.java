package org.robotui.rfic.recording.internal.compare;

import java.util.List;
import java.util.Optional;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * Moves points onto others so that the sum of the squares of their distances is least. The turn is the same that
 * Umeyama's method finds by a singular value decomposition; here it is the eigenvector of the largest eigenvalue of a
 * symmetric matrix.
 *
 * <p>Sources: B. K. P. Horn, Closed-form solution of absolute orientation using unit quaternions, 1987; S. Umeyama,
 * Least-squares estimation of transformation parameters between two point patterns, 1991.
 */
final class PointFit {
  private static final int SIZE = 4;
  private static final int MOST_SWEEPS = 60;
  /** Turns around the line on which all points lie fit equally well. */
  private static final double TIED = 1e-9;

  private final Vector3 movedMean;
  private final Vector3 fixedMean;
  /** Sums of products: moved by rows, fixed by columns. */
  private final double[][] sums = new double[3][3];

  PointFit(List<RigidTransform> moved, List<RigidTransform> fixed) {
    movedMean = mean(moved);
    fixedMean = mean(fixed);
    for (int i = 0; i < moved.size(); i++) {
      double[] m = array(moved.get(i).translation().minus(movedMean));
      double[] f = array(fixed.get(i).translation().minus(fixedMean));
      for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) {
          sums[row][column] += m[row] * f[column];
        }
      }
    }
  }

  private static Vector3 mean(List<RigidTransform> poses) {
    return poses.stream().map(RigidTransform::translation).reduce(Vector3.ZERO, Vector3::plus)
        .times(1.0 / poses.size());
  }

  private static double[] array(Vector3 v) {
    return new double[]{v.x(), v.y(), v.z()};
  }

  /** Any turn; empty where the points do not tell it, as they lie on a line or at one place. */
  Optional<RigidTransform> free() {
    double[][] values = horn();
    double[][] vectors = eigen(values);
    int best = 0;
    for (int i = 1; i < SIZE; i++) {
      best = values[i][i] > values[best][best] ? i : best;
    }
    double second = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < SIZE; i++) {
      second = i == best ? second : Math.max(second, values[i][i]);
    }
    double largest = values[best][best];
    if (!(largest - second > TIED * Math.max(Math.abs(largest), Double.MIN_NORMAL))) {
      return Optional.empty();
    }
    return Optional.of(around(new Quaternion(vectors[1][best], vectors[2][best], vectors[3][best], vectors[0][best])
        .normalized()));
  }

  /** A turn around the vertical axis alone. */
  RigidTransform level() {
    return around(Quaternion.fromYaw(Math.atan2(sums[0][1] - sums[1][0], sums[0][0] + sums[1][1])));
  }

  private RigidTransform around(Quaternion turn) {
    return new RigidTransform(fixedMean.minus(turn.rotate(movedMean)), turn);
  }

  private double[][] horn() {
    double[][] s = sums;
    return new double[][]{
        {s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]},
        {s[1][2] - s[2][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]},
        {s[2][0] - s[0][2], s[0][1] + s[1][0], s[1][1] - s[0][0] - s[2][2], s[1][2] + s[2][1]},
        {s[0][1] - s[1][0], s[2][0] + s[0][2], s[1][2] + s[2][1], s[2][2] - s[0][0] - s[1][1]}};
  }

  /** Makes a symmetric matrix diagonal by Jacobi's rotations; the columns of the answer are its eigenvectors. */
  private static double[][] eigen(double[][] a) {
    double[][] vectors = new double[SIZE][SIZE];
    for (int i = 0; i < SIZE; i++) {
      vectors[i][i] = 1;
    }
    for (int sweep = 0; sweep < MOST_SWEEPS; sweep++) {
      for (int p = 0; p < SIZE - 1; p++) {
        for (int q = p + 1; q < SIZE; q++) {
          if (a[p][q] != 0) {
            rotate(a, vectors, p, q);
          }
        }
      }
    }
    return vectors;
  }

  private static void rotate(double[][] a, double[][] vectors, int p, int q) {
    double ratio = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double tangent = Math.signum(ratio) / (Math.abs(ratio) + Math.sqrt(ratio * ratio + 1));
    tangent = ratio == 0 ? 1 : tangent;
    double cosine = 1 / Math.sqrt(tangent * tangent + 1);
    double sine = tangent * cosine;
    for (int k = 0; k < SIZE; k++) {
      double kp = a[k][p];
      double kq = a[k][q];
      a[k][p] = cosine * kp - sine * kq;
      a[k][q] = sine * kp + cosine * kq;
    }
    for (int k = 0; k < SIZE; k++) {
      double pk = a[p][k];
      double qk = a[q][k];
      a[p][k] = cosine * pk - sine * qk;
      a[q][k] = sine * pk + cosine * qk;
      double vp = vectors[k][p];
      double vq = vectors[k][q];
      vectors[k][p] = cosine * vp - sine * vq;
      vectors[k][q] = sine * vp + cosine * vq;
    }
  }
}
