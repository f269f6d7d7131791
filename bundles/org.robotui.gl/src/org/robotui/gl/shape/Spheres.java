package org.robotui.gl.shape;

import java.util.HashMap;
import java.util.Map;
import org.robotui.geometry.Vector3;

/** Spheres from an icosahedron: all triangles about as large, none at the poles wasted. */
final class Spheres {
  private static final double GOLDEN = (1 + Math.sqrt(5)) / 2;
  private static final double[][] CORNERS = {
      {-1, GOLDEN, 0}, {1, GOLDEN, 0}, {-1, -GOLDEN, 0}, {1, -GOLDEN, 0}, {0, -1, GOLDEN}, {0, 1, GOLDEN},
      {0, -1, -GOLDEN}, {0, 1, -GOLDEN},
      {GOLDEN, 0, -1}, {GOLDEN, 0, 1}, {-GOLDEN, 0, -1}, {-GOLDEN, 0, 1}
  };
  private static final int[][] FACES = {
      {0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6},
      {7, 1, 8},
      {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8}, {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}
  };

  private final MeshBuilder mesh = new MeshBuilder();
  private final Map<Vector3, Integer> known = new HashMap<>();

  private Spheres() {}

  /** A sphere of diameter 1; each division makes four triangles of one, from 20. */
  static TriangleMesh sphere(int divisions) {
    Spheres spheres = new Spheres();
    for (int[] face : FACES) {
      spheres.divide(unit(face[0]), unit(face[1]), unit(face[2]), divisions);
    }
    return spheres.mesh.build();
  }

  private void divide(Vector3 a, Vector3 b, Vector3 c, int divisions) {
    if (divisions == 0) {
      mesh.triangle(index(a), index(b), index(c));
      return;
    }
    Vector3 ab = onSphere(a.plus(b));
    Vector3 bc = onSphere(b.plus(c));
    Vector3 ca = onSphere(c.plus(a));
    divide(a, ab, ca, divisions - 1);
    divide(ab, b, bc, divisions - 1);
    divide(ca, bc, c, divisions - 1);
    divide(ab, bc, ca, divisions - 1);
  }

  /** Sums of the same two corners are the same numbers in either order, so a corner is found again. */
  private int index(Vector3 at) {
    return known.computeIfAbsent(at, p -> mesh.corner(p.x() / 2, p.y() / 2, p.z() / 2, p.x(), p.y(), p.z()));
  }

  private static Vector3 unit(int corner) {
    return onSphere(new Vector3(CORNERS[corner][0], CORNERS[corner][1], CORNERS[corner][2]));
  }

  private static Vector3 onSphere(Vector3 v) {
    return v.times(1 / v.norm());
  }
}
