package org.robotui.gl.internal.draw;

import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * A matrix of four columns of four. Double precision until it is sent, so that what lies far from the origin does not
 * tremble.
 *
 * @param columns sixteen numbers, column by column
 */
public record Matrix(double[] columns) {
  private static final int SIDE = 4;

  /**
   * A transform.
   *
   * @param transform rotation and translation
   * @return as a matrix
   */
  public static Matrix of(RigidTransform transform) {
    Quaternion turn = transform.rotation();
    Vector3 x = turn.rotate(new Vector3(1, 0, 0));
    Vector3 y = turn.rotate(new Vector3(0, 1, 0));
    Vector3 z = turn.rotate(new Vector3(0, 0, 1));
    Vector3 t = transform.translation();
    return new Matrix(
        new double[]{x.x(), x.y(), x.z(), 0, y.x(), y.y(), y.z(), 0, z.x(), z.y(), z.z(), 0, t.x(), t.y(), t.z(), 1});
  }

  /**
   * Composes.
   *
   * @param other applied first
   * @return the product
   */
  public Matrix times(Matrix other) {
    double[] product = new double[SIDE * SIDE];
    for (int column = 0; column < SIDE; column++) {
      for (int row = 0; row < SIDE; row++) {
        double sum = 0;
        for (int i = 0; i < SIDE; i++) {
          sum += columns[SIDE * i + row] * other.columns[SIDE * column + i];
        }
        product[SIDE * column + row] = sum;
      }
    }
    return new Matrix(product);
  }

  /**
   * Transforms a place.
   *
   * @param place x, y, z with w = 1
   * @return x, y, z, w
   */
  public double[] apply(Vector3 place) {
    double[] result = new double[SIDE];
    for (int row = 0; row < SIDE; row++) {
      result[row] = columns[row] * place.x() + columns[SIDE + row] * place.y() + columns[2 * SIDE + row] * place.z()
          + columns[3 * SIDE + row];
    }
    return result;
  }

  /**
   * For the graphics card.
   *
   * @return the numbers in single precision
   */
  public float[] floats() {
    float[] result = new float[columns.length];
    for (int i = 0; i < result.length; i++) {
      result[i] = (float) columns[i];
    }
    return result;
  }
}
