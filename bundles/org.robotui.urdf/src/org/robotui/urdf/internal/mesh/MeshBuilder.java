package org.robotui.urdf.internal.mesh;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.urdf.Color;
import org.robotui.urdf.internal.Refusal;
import org.robotui.urdf.mesh.Mesh;

/** Collects corners and triangles, and refuses too many and those that lie nowhere. */
public final class MeshBuilder {
  /** Triangles of a mesh. */
  public static final int MOST_TRIANGLES = 20_000_000;

  private static final long MOST_BYTES = 512L << 20;

  private final FloatList xyz = new FloatList();
  private final FloatList normals = new FloatList();
  private final FloatList uv = new FloatList();
  private final IntList triangles = new IntList();
  private final List<Mesh.Part> parts = new ArrayList<>();
  private int partCorner;
  private int partTriangle;
  private boolean textured;

  int corner(float x, float y, float z) throws Refusal {
    if (!Float.isFinite(x) || !Float.isFinite(y) || !Float.isFinite(z)) {
      throw new Refusal(0, "corner " + xyz.size() / 3 + " has a coordinate that is no finite number");
    }
    add(xyz, x, y, z);
    add(normals, 0, 0, 0);
    uv.add(0);
    uv.add(0);
    return xyz.size() / 3 - 1;
  }

  void normal(int corner, double x, double y, double z) {
    double length = Math.sqrt(x * x + y * y + z * z);
    if (length > 0 && Double.isFinite(length)) {
      normals.set(3 * corner, (float) (x / length));
      normals.set(3 * corner + 1, (float) (y / length));
      normals.set(3 * corner + 2, (float) (z / length));
    }
  }

  void place(int corner, float u, float v) {
    uv.set(2 * corner, Float.isFinite(u) ? u : 0);
    uv.set(2 * corner + 1, Float.isFinite(v) ? v : 0);
    textured = true;
  }

  void triangle(int a, int b, int c) throws Refusal {
    triangles.add(a);
    triangles.add(b);
    triangles.add(c);
    long bytes = 4L * (xyz.size() + normals.size() + uv.size() + triangles.size());
    if (triangles.size() / 3 > MOST_TRIANGLES || bytes > MOST_BYTES) {
      throw new Refusal(0,
          "the mesh has more than " + MOST_TRIANGLES + " triangles or takes more than 512 MB; make a coarser one");
    }
  }

  /** Three corners that lack a normal share that of their triangle. */
  void flat(int a, int b, int c) {
    double ux = xyz.get(3 * b) - xyz.get(3 * a);
    double uy = xyz.get(3 * b + 1) - xyz.get(3 * a + 1);
    double uz = xyz.get(3 * b + 2) - xyz.get(3 * a + 2);
    double vx = xyz.get(3 * c) - xyz.get(3 * a);
    double vy = xyz.get(3 * c + 1) - xyz.get(3 * a + 1);
    double vz = xyz.get(3 * c + 2) - xyz.get(3 * a + 2);
    for (int corner : new int[]{a, b, c}) {
      if (!hasNormal(corner)) {
        normal(corner, uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
      }
    }
  }

  /** Ends the triangles of one surface. */
  void part(Optional<Color> color, Optional<String> texture) {
    int corners = xyz.size() / 3;
    int count = triangles.size() / 3;
    if (count > partTriangle) {
      parts.add(new Mesh.Part(partCorner, corners - partCorner, partTriangle, count - partTriangle, color, texture));
    }
    partCorner = corners;
    partTriangle = count;
  }

  /** The mesh of all parts. */
  public Mesh build() throws Refusal {
    if (parts.isEmpty()) {
      throw new Refusal(0, "the file has no triangle");
    }
    for (int corner = 0; corner < xyz.size() / 3; corner++) {
      if (!hasNormal(corner)) {
        // of a triangle without an area; any direction will do
        normals.set(3 * corner + 2, 1);
      }
    }
    return new Mesh(xyz.buffer(), normals.buffer(), textured ? Optional.of(uv.buffer()) : Optional.empty(),
        triangles.buffer(), parts);
  }

  private boolean hasNormal(int corner) {
    return normals.get(3 * corner) != 0 || normals.get(3 * corner + 1) != 0 || normals.get(3 * corner + 2) != 0;
  }

  private static void add(FloatList list, float x, float y, float z) {
    list.add(x);
    list.add(y);
    list.add(z);
  }
}
