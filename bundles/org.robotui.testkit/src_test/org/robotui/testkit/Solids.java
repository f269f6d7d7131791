package org.robotui.testkit;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.robotui.gl.shape.TriangleMesh;

/** Bodies to look at. */
final class Solids {
  private Solids() {}

  /** A box around the origin, whose flat sides the renderer finds itself. */
  static TriangleMesh box(float x, float y, float z) {
    FloatBuffer xyz = FloatBuffer.allocate(24);
    for (int i = 0; i < 8; i++) {
      xyz.put((i & 1) == 0 ? -x / 2 : x / 2).put((i & 2) == 0 ? -y / 2 : y / 2).put((i & 4) == 0 ? -z / 2 : z / 2);
    }
    int[] triangles =
        {0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 3, 7, 1, 7, 5};
    return TriangleMesh.of(xyz.flip(), Optional.empty(), IntBuffer.wrap(triangles));
  }
}
