package org.robotui.gl.internal.draw;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;
import org.robotui.gl.shape.TriangleMesh;

/**
 * Tells how nearly a mesh is the surface of a body: of such a one the triangles that face away are hidden by others,
 * and need not be drawn.
 */
final class Solid {
  private static final int CORNERS = 3;
  /** Cells across a mesh in which corners count as one: fewer than a cell has bits for. */
  private static final int CELLS = 1 << 19;

  private Solid() {}

  /**
   * The share of edges that are not between two triangles of the same sense.
   *
   * @return 0 for the surface of a body, 1 for what is none or is turned inside out
   */
  static double openness(TriangleMesh mesh) {
    return mesh.bounds().filter(b -> b.radius() > 0 && volume(mesh) > 0)
        .map(b -> openness(new Cells(mesh, 2 * b.radius() / CELLS).merged(mesh.triangles()))).orElse(1.0);
  }

  private static double openness(IntBuffer triangles) {
    long[] edges = new long[triangles.remaining()];
    for (int i = 0; i < edges.length; i++) {
      int from = triangles.get(i);
      int to = triangles.get(i % CORNERS == CORNERS - 1 ? i - CORNERS + 1 : i + 1);
      edges[i] = from < to ? edge(from, to) : edge(to, from) | 1;
    }
    Arrays.sort(edges);
    long open = 0;
    for (int first = 0, next; first < edges.length; first = next) {
      int balance = 0;
      for (next = first; next < edges.length && edges[next] >>> 1 == edges[first] >>> 1; next++) {
        balance += (edges[next] & 1) == 0 ? 1 : -1;
      }
      open += Math.abs(balance);
    }
    return edges.length == 0 ? 1 : (double) open / edges.length;
  }

  /** Both corners, with a bit for the direction below them. */
  private static long edge(int low, int high) {
    return ((long) low << Integer.SIZE - 1 | high) << 1;
  }

  /** Of the body inside, times six; cubic metres. */
  private static double volume(TriangleMesh mesh) {
    FloatBuffer at = mesh.xyz();
    double sum = 0;
    for (int i = 0; i < mesh.triangles().remaining(); i += CORNERS) {
      int a = CORNERS * mesh.triangles().get(i);
      int b = CORNERS * mesh.triangles().get(i + 1);
      int c = CORNERS * mesh.triangles().get(i + 2);
      sum += at.get(a) * ((double) at.get(b + 1) * at.get(c + 2) - (double) at.get(b + 2) * at.get(c + 1))
          + at.get(a + 1) * ((double) at.get(b + 2) * at.get(c) - (double) at.get(b) * at.get(c + 2))
          + at.get(a + 2) * ((double) at.get(b) * at.get(c + 1) - (double) at.get(b + 1) * at.get(c));
    }
    return sum;
  }
}
