package org.robotui.gl.internal.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.gl.shape.TriangleMesh;

class LevelsTest {
  private static final int SIDE = 200;

  /** A sheet of a metre, of triangles that share no corners, as STL files have them. */
  private static TriangleMesh sheet() {
    FloatBuffer xyz = FloatBuffer.allocate(SIDE * SIDE * 18);
    for (int cell = 0; cell < SIDE * SIDE; cell++) {
      float x = cell % SIDE;
      float y = cell / SIDE;
      float[][] corners = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y}, {x + 1, y + 1}, {x, y + 1}};
      for (float[] corner : corners) {
        xyz.put(corner[0] / SIDE).put(corner[1] / SIDE).put(0);
      }
    }
    IntBuffer indices = IntBuffer.allocate(SIDE * SIDE * 6);
    while (indices.hasRemaining()) {
      indices.put(indices.position());
    }
    return TriangleMesh.of(xyz.flip(), Optional.empty(), indices.flip());
  }

  private static double area(TriangleMesh mesh, Levels levels, Levels.Level level) {
    IntBuffer all = levels.indices();
    FloatBuffer at = mesh.xyz();
    double sum = 0;
    for (int i = level.first(); i < level.first() + level.count(); i += 3) {
      int a = 3 * all.get(i);
      int b = 3 * all.get(i + 1);
      int c = 3 * all.get(i + 2);
      sum += ((at.get(b) - at.get(a)) * (at.get(c + 1) - at.get(a + 1))
          - (at.get(c) - at.get(a)) * (at.get(b + 1) - at.get(a + 1))) / 2;
    }
    return sum;
  }

  @Test
  void theFinestIsTheMeshAndCoarserOnesHaveFewerTrianglesOfTheSameSurface() {
    TriangleMesh mesh = sheet();
    Levels levels = Levels.of(mesh);
    Levels.Level finest = levels.within(0);
    assertEquals(new Levels.Level(0, mesh.triangles().remaining(), 0), finest);
    assertEquals(1, area(mesh, levels, finest), 1e-3);
    Levels.Level coarse = levels.within(0.05);
    assertTrue(coarse.count() < finest.count() / 10, () -> coarse + " of " + finest);
    assertTrue(coarse.error() <= 0.05);
    assertEquals(1, area(mesh, levels, coarse), 0.2);
    assertTrue(levels.within(0.01).count() > coarse.count());
  }

  @Test
  void whatIsNoNumberOrHasNoExtentIsLeftAsItIs() {
    FloatBuffer nan = FloatBuffer.allocate(9 * 1000);
    for (int i = 0; i < nan.capacity(); i++) {
      nan.put(i, Float.NaN);
    }
    IntBuffer indices = IntBuffer.allocate(3 * 1000);
    while (indices.hasRemaining()) {
      indices.put(indices.position());
    }
    TriangleMesh broken = TriangleMesh.of(nan, Optional.empty(), indices.flip());
    assertEquals(3000, Levels.of(broken).within(1).count());
    TriangleMesh point = TriangleMesh.of(FloatBuffer.allocate(9 * 1000), Optional.empty(), indices);
    assertEquals(3000, Levels.of(point).within(1).count());
  }
}
