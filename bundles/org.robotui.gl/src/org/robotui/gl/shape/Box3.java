package org.robotui.gl.shape;

import java.nio.FloatBuffer;
import java.util.Optional;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * The space between two corners, edges along the axes.
 *
 * @param low least x, y, z; metres
 * @param high greatest x, y, z; metres
 */
public record Box3(Vector3 low, Vector3 high) {
  /**
   * The smallest box around points. Points with a coordinate that is no finite number do not count.
   *
   * @param xyz x, y, z in turn, from position to limit; its position stays
   * @return the box, or none without a point
   */
  public static Optional<Box3> around(FloatBuffer xyz) {
    float[] low = {Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY};
    float[] high = {Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY};
    for (int i = xyz.position(); i + 2 < xyz.limit(); i += 3) {
      float x = xyz.get(i);
      float y = xyz.get(i + 1);
      float z = xyz.get(i + 2);
      if (Float.isFinite(x + y + z)) {
        low[0] = Math.min(low[0], x);
        low[1] = Math.min(low[1], y);
        low[2] = Math.min(low[2], z);
        high[0] = Math.max(high[0], x);
        high[1] = Math.max(high[1], y);
        high[2] = Math.max(high[2], z);
      }
    }
    return low[0] > high[0]
        ? Optional.empty()
        : Optional.of(new Box3(new Vector3(low[0], low[1], low[2]), new Vector3(high[0], high[1], high[2])));
  }

  /**
   * The smallest box around two.
   *
   * @param other another box
   * @return both
   */
  public Box3 union(Box3 other) {
    return new Box3(least(low, other.low), greatest(high, other.high));
  }

  /**
   * The smallest box, with edges along the axes of another frame, around this one.
   *
   * @param otherFromThis where this frame lies in the other
   * @return the box in the other frame
   */
  public Box3 in(RigidTransform otherFromThis) {
    Vector3 first = otherFromThis.apply(low);
    Box3 box = new Box3(first, first);
    for (int corner = 1; corner < 8; corner++) {
      Vector3 at = otherFromThis.apply(new Vector3(
          (corner & 1) == 0 ? low.x() : high.x(), (corner & 2) == 0 ? low.y() : high.y(),
          (corner & 4) == 0 ? low.z() : high.z()));
      box = box.union(new Box3(at, at));
    }
    return box;
  }

  /**
   * The same box, wider on all sides.
   *
   * @param margin metres
   * @return the wider box
   */
  public Box3 grown(double margin) {
    Vector3 by = new Vector3(margin, margin, margin);
    return new Box3(low.minus(by), high.plus(by));
  }

  /**
   * The middle.
   *
   * @return metres
   */
  public Vector3 center() {
    return low.plus(high).times(0.5);
  }

  /**
   * Half of the diagonal.
   *
   * @return metres
   */
  public double radius() {
    return high.minus(low).norm() / 2;
  }

  private static Vector3 least(Vector3 a, Vector3 b) {
    return new Vector3(Math.min(a.x(), b.x()), Math.min(a.y(), b.y()), Math.min(a.z(), b.z()));
  }

  private static Vector3 greatest(Vector3 a, Vector3 b) {
    return new Vector3(Math.max(a.x(), b.x()), Math.max(a.y(), b.y()), Math.max(a.z(), b.z()));
  }
}
