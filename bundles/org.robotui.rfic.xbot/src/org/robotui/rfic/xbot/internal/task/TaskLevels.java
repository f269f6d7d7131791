package org.robotui.rfic.xbot.internal.task;

/**
 * Steps of joints that do tasks in the order of their priority: damped least squares, each level in the directions that
 * those before it leave. One step: solve for each level, the first one first.
 */
final class TaskLevels {
  private static final double DAMPING = 0.02;
  private static final double NOTHING = 1e-4;

  private final int joints;
  private final double[] step;
  private final double[][] free;

  TaskLevels(int joints, boolean[] held) {
    this.joints = joints;
    this.step = new double[joints];
    this.free = new double[joints][joints];
    for (int i = 0; i < joints; i++) {
      free[i][i] = held[i] ? 0 : 1;
    }
  }

  double[] step() {
    return step;
  }

  /**
   * The next level.
   *
   * @param rows how its values change with each joint
   * @param wanted by how much they shall change
   */
  void solve(double[][] rows, double[] wanted) {
    int count = rows.length;
    double[][] projected = new double[count][joints];
    double[] missing = wanted.clone();
    for (int r = 0; r < count; r++) {
      for (int i = 0; i < joints; i++) {
        missing[r] -= rows[r][i] * step[i];
        for (int k = 0; k < joints; k++) {
          projected[r][i] += rows[r][k] * free[k][i];
        }
      }
    }
    add(projected, solved(square(projected), missing));
    leave(projected);
  }

  private static double[][] square(double[][] projected) {
    int count = projected.length;
    double[][] square = new double[count][count];
    for (int r = 0; r < count; r++) {
      for (int c = 0; c < count; c++) {
        square[r][c] = dot(projected[r], projected[c]) + (r == c ? DAMPING * DAMPING : 0);
      }
    }
    return square;
  }

  private void add(double[][] projected, double[] weights) {
    for (int r = 0; r < weights.length; r++) {
      for (int i = 0; i < joints; i++) {
        step[i] += projected[r][i] * weights[r];
      }
    }
  }

  /** What this level does not need: exactly, as what a damped one leaves would be made use of by those below it. */
  private void leave(double[][] projected) {
    for (double[] row : projected) {
      double[] rest = new double[joints];
      for (int i = 0; i < joints; i++) {
        rest[i] = dot(free[i], row);
      }
      double length = Math.sqrt(dot(rest, rest));
      for (int i = 0; i < joints && length > NOTHING; i++) {
        rest[i] /= length;
      }
      for (int i = 0; i < joints && length > NOTHING; i++) {
        for (int k = 0; k < joints; k++) {
          free[i][k] -= rest[i] * rest[k];
        }
      }
    }
  }

  private static double dot(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  /** By Cholesky's factor; the matrix is symmetric and positive definite by its damping. */
  private static double[] solved(double[][] matrix, double[] right) {
    int n = right.length;
    double[][] lower = new double[n][n];
    double[] x = new double[n];
    for (int r = 0; r < n; r++) {
      for (int c = 0; c <= r; c++) {
        double sum = matrix[r][c];
        for (int k = 0; k < c; k++) {
          sum -= lower[r][k] * lower[c][k];
        }
        lower[r][c] = r == c ? Math.sqrt(Math.max(sum, Double.MIN_NORMAL)) : sum / lower[c][c];
      }
      double sum = right[r];
      for (int k = 0; k < r; k++) {
        sum -= lower[r][k] * x[k];
      }
      x[r] = sum / lower[r][r];
    }
    for (int r = n - 1; r >= 0; r--) {
      for (int k = r + 1; k < n; k++) {
        x[r] -= lower[k][r] * x[k];
      }
      x[r] /= lower[r][r];
    }
    return x;
  }
}
