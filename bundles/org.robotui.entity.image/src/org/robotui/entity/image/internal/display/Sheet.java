package org.robotui.entity.image.internal.display;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.TriangleMesh;

/**
 * A rectangle across the axis of sight, in the optical frame (x right, y down, z forward).
 *
 * @param left x of its left edge, metres
 * @param top y of its upper edge
 * @param right x of its right edge
 * @param bottom y of its lower edge
 * @param z how far before the frame
 */
record Sheet(double left, double top, double right, double bottom, double z) {
  private static final double FARTHEST = 1e5;

  /** Whether it can be drawn. */
  boolean possible() {
    return possible(left) && possible(top) && possible(right) && possible(bottom) && possible(z) && right > left
        && bottom > top;
  }

  private static boolean possible(double metres) {
    return Math.abs(metres) < FARTHEST;
  }

  /** Its surface: the first row of a texture is at its upper edge. */
  TriangleMesh mesh() {
    FloatBuffer xyz =
        FloatBuffer.wrap(new float[]{(float) left, (float) top, (float) z, (float) right, (float) top, (float) z,
            (float) right, (float) bottom, (float) z, (float) left, (float) bottom, (float) z});
    FloatBuffer uv = FloatBuffer.wrap(new float[]{0, 0, 1, 0, 1, 1, 0, 1});
    return new TriangleMesh(xyz, Optional.empty(), Optional.of(uv), Optional.empty(),
        IntBuffer.wrap(new int[]{0, 1, 2, 0, 2, 3}), Box3.around(xyz));
  }

  /** The edges of the pyramid from the frame to its corners, and its own. */
  float[] pyramid() {
    float[][] corners = {{(float) left, (float) top}, {(float) right, (float) top}, {(float) right, (float) bottom},
        {(float) left, (float) bottom}};
    float[] xyz = new float[6 * 8];
    for (int i = 0; i < 4; i++) {
      float[] next = corners[(i + 1) % 4];
      put(xyz, 12 * i, 0, 0, 0);
      put(xyz, 12 * i + 3, corners[i][0], corners[i][1], (float) z);
      put(xyz, 12 * i + 6, corners[i][0], corners[i][1], (float) z);
      put(xyz, 12 * i + 9, next[0], next[1], (float) z);
    }
    return xyz;
  }

  private static void put(float[] xyz, int at, float x, float y, float z) {
    xyz[at] = x;
    xyz[at + 1] = y;
    xyz[at + 2] = z;
  }
}
