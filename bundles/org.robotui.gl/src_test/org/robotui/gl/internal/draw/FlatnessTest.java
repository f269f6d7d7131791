package org.robotui.gl.internal.draw;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.TriangleMesh;

class FlatnessTest {
  private static final FloatBuffer CORNERS = FloatBuffer.wrap(new float[]{0, 0, 0, 1, 0, 0, 0, 1, 0});
  private static final IntBuffer ONE = IntBuffer.wrap(new int[]{0, 1, 2});

  @Test
  void boxesAndWhatHasNoNormalsAreFlat() {
    assertTrue(Flatness.isFlat(Meshes.cube()));
    assertTrue(Flatness.isFlat(TriangleMesh.of(CORNERS, Optional.empty(), ONE)));
  }

  @Test
  void aTriangleWhoseCornersFaceDifferentWaysIsNot() {
    FloatBuffer normals = FloatBuffer.wrap(new float[]{0, 0, 1, 0, 0, 1, 0, 0.6f, 0.8f});
    assertFalse(Flatness.isFlat(TriangleMesh.of(CORNERS, Optional.of(normals), ONE)));
  }
}
