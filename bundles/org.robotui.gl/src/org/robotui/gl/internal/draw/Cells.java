package org.robotui.gl.internal.draw;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.TriangleMesh;

/**
 * The corners of a mesh by the cells of a grid in which they are. Which way they face does not matter: where corners of
 * one place were drawn at two, the surface would have cracks.
 */
final class Cells {
  private static final int CORNERS = 3;
  private static final int AXIS_BITS = 20;
  private static final long AXIS = (1 << AXIS_BITS) - 1;
  private static final long EMPTY = -1;
  private static final int SAMPLES = 1000;
  private static final long MIXER = 0x9e3779b97f4a7c15L;

  private final FloatBuffer xyz;
  private final Vector3 low;
  private final double cell;
  private final long[] keys;
  private final int[] corners;

  /**
   * Puts nothing into them yet.
   *
   * @param mesh with bounds
   * @param cell edge, metres
   */
  Cells(TriangleMesh mesh, double cell) {
    xyz = mesh.xyz();
    low = mesh.bounds().orElseThrow().low();
    this.cell = cell;
    int slots = Integer.highestOneBit(Math.max(1, xyz.remaining() / CORNERS)) * 4;
    keys = new long[slots];
    Arrays.fill(keys, EMPTY);
    corners = new int[slots];
  }

  /** How far corners of one triangle are apart, as a mean of some; metres. */
  static double spacing(TriangleMesh mesh) {
    int stride = Math.max(1, mesh.elements() / SAMPLES);
    double sum = 0;
    int count = 0;
    for (int i = 0; i < mesh.elements(); i += stride) {
      int a = CORNERS * mesh.triangles().get(CORNERS * i);
      int b = CORNERS * mesh.triangles().get(CORNERS * i + 1);
      double apart =
          Math.hypot(Math.hypot(mesh.xyz().get(a) - mesh.xyz().get(b), mesh.xyz().get(a + 1) - mesh.xyz().get(b + 1)),
              mesh.xyz().get(a + 2) - mesh.xyz().get(b + 2));
      if (Double.isFinite(apart)) {
        sum += apart;
        count++;
      }
    }
    return count == 0 ? 0 : sum / count / 2;
  }

  /** The triangles whose corners are in three cells, each cell with the first corner that was found in it. */
  IntBuffer merged(IntBuffer triangles) {
    IntBuffer left = IntBuffer.allocate(triangles.remaining());
    for (int i = 0; i < triangles.remaining(); i += CORNERS) {
      int a = corner(triangles.get(i));
      int b = corner(triangles.get(i + 1));
      int c = corner(triangles.get(i + 2));
      if (a != b && b != c && c != a) {
        left.put(a).put(b).put(c);
      }
    }
    return IntBuffer.wrap(Arrays.copyOf(left.array(), left.position()));
  }

  private int corner(int index) {
    long key = key(index);
    int slot = (int) (key * MIXER >>> Long.SIZE / 2) & keys.length - 1;
    while (keys[slot] != EMPTY && keys[slot] != key) {
      slot = slot + 1 & keys.length - 1;
    }
    if (keys[slot] == EMPTY) {
      keys[slot] = key;
      corners[slot] = index;
    }
    return corners[slot];
  }

  private long key(int index) {
    int at = CORNERS * index;
    return along(xyz.get(at), low.x()) << 2 * AXIS_BITS | along(xyz.get(at + 1), low.y()) << AXIS_BITS
        | along(xyz.get(at + 2), low.z());
  }

  private long along(float value, double from) {
    return (long) ((value - from) / cell) & AXIS;
  }
}
