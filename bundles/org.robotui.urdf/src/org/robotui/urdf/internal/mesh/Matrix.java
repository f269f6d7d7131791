package org.robotui.urdf.internal.mesh;

/** A linear map with a translation, row by row: three rows of four numbers. */
record Matrix(double[] m) {
  static final Matrix IDENTITY = new Matrix(new double[]{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});

  static Matrix scaled(double x, double y, double z) {
    return new Matrix(new double[]{x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0});
  }

  static Matrix moved(double x, double y, double z) {
    return new Matrix(new double[]{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z});
  }

  static Matrix turned(double x, double y, double z, double angle) {
    double length = Math.sqrt(x * x + y * y + z * z);
    if (!(length > 0)) {
      return IDENTITY;
    }
    double s = Math.sin(angle);
    double c = Math.cos(angle);
    double a = x / length;
    double b = y / length;
    double d = z / length;
    return new Matrix(new double[]{
        c + a * a * (1 - c), a * b * (1 - c) - d * s, a * d * (1 - c) + b * s, 0,
        b * a * (1 - c) + d * s, c + b * b * (1 - c), b * d * (1 - c) - a * s, 0,
        d * a * (1 - c) - b * s, d * b * (1 - c) + a * s, c + d * d * (1 - c), 0});
  }

  Matrix times(Matrix other) {
    double[] product = new double[12];
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 4; column++) {
        double sum = column == 3 ? m[4 * row + 3] : 0;
        for (int k = 0; k < 3; k++) {
          sum += m[4 * row + k] * other.m[4 * k + column];
        }
        product[4 * row + column] = sum;
      }
    }
    return new Matrix(product);
  }

  /** A coordinate of a place. */
  float place(int row, double x, double y, double z) {
    return (float) (m[4 * row] * x + m[4 * row + 1] * y + m[4 * row + 2] * z + m[4 * row + 3]);
  }

  /**
   * What turns normals: the matrix of cofactors, which is the inverse transposed but for a factor, and there also where
   * no inverse is.
   */
  double normal(int row, double x, double y, double z) {
    int a = 4 * ((row + 1) % 3);
    int b = 4 * ((row + 2) % 3);
    double sign = determinant() < 0 ? -1 : 1;
    return sign * (x * (m[a + 1] * m[b + 2] - m[a + 2] * m[b + 1]) + y * (m[a + 2] * m[b] - m[a] * m[b + 2])
        + z * (m[a] * m[b + 1] - m[a + 1] * m[b]));
  }

  private double determinant() {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8])
        + m[2] * (m[4] * m[9] - m[5] * m[8]);
  }
}
