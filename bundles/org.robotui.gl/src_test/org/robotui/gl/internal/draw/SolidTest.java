package org.robotui.gl.internal.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.TriangleMesh;

class SolidTest {
  /** Triangles that share no corners, as STL files have them; some left out, or all turned inside out. */
  private static TriangleMesh loose(TriangleMesh mesh, int leftOut, boolean insideOut) {
    IntBuffer from = mesh.triangles();
    int count = from.remaining() - 3 * leftOut;
    FloatBuffer xyz = FloatBuffer.allocate(3 * count);
    for (int i = 0; i < count; i++) {
      int corner = insideOut ? i / 3 * 3 + 2 - i % 3 : i;
      xyz.put(mesh.xyz().slice(3 * from.get(corner), 3));
    }
    int[] indices = new int[count];
    for (int i = 0; i < count; i++) {
      indices[i] = i;
    }
    return TriangleMesh.of(xyz.flip(), Optional.empty(), IntBuffer.wrap(indices));
  }

  @Test
  void theSurfaceOfABodyHasNoOpenEdges() {
    assertEquals(0, Solid.openness(Meshes.sphere()));
    assertEquals(0, Solid.openness(Meshes.cube()));
    assertEquals(0, Solid.openness(loose(Meshes.sphere(), 0, false)));
  }

  @Test
  void aHoleOfOneTriangleOpensThreeEdges() {
    int edges = 3 * (Meshes.sphere().elements() - 1);
    assertEquals(3.0 / edges, Solid.openness(loose(Meshes.sphere(), 1, false)), 1e-9);
  }

  @Test
  void whatIsInsideOutOrFlatOrNoNumberIsNoBody() {
    assertEquals(1, Solid.openness(loose(Meshes.sphere(), 0, true)));
    assertEquals(1, Solid.openness(Meshes.quad()));
    FloatBuffer nan = FloatBuffer.wrap(new float[]{Float.NaN, 0, 0, 0, Float.NaN, 0, 0, 0, 1});
    assertEquals(1, Solid.openness(TriangleMesh.of(nan, Optional.empty(), IntBuffer.wrap(new int[]{0, 1, 2}))));
    assertEquals(1, Solid.openness(TriangleMesh.of(FloatBuffer.allocate(0), Optional.empty(), IntBuffer.allocate(0))));
  }
}
