package org.robotui.gl.internal.draw;

import java.nio.FloatBuffer;
import org.robotui.gl.shape.TriangleMesh;

/**
 * Tells whether light is about the same all over each triangle of a mesh, so that it need not be computed for each
 * pixel.
 */
final class Flatness {
  private static final int CORNERS = 3;
  /** Of the angle between the directions of two corners: 15 degrees. */
  private static final double ALIKE = 0.966;

  private Flatness() {}

  /** Whether no triangle has corners that face different ways, as boxes have and finely divided cylinders. */
  static boolean isFlat(TriangleMesh mesh) {
    return mesh.normals().map(normals -> isFlat(mesh, normals)).orElse(true);
  }

  private static boolean isFlat(TriangleMesh mesh, FloatBuffer normals) {
    boolean flat = true;
    for (int i = 0; i < mesh.triangles().remaining() && flat; i++) {
      int other = i % CORNERS == CORNERS - 1 ? i - CORNERS + 1 : i + 1;
      flat = alike(normals, CORNERS * mesh.triangles().get(i), CORNERS * mesh.triangles().get(other)) >= ALIKE;
    }
    return flat;
  }

  private static double alike(FloatBuffer normals, int a, int b) {
    return normals.get(a) * normals.get(b) + normals.get(a + 1) * normals.get(b + 1)
        + normals.get(a + 2) * normals.get(b + 2);
  }
}
