package org.robotui.gl.shape;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;
import java.util.Optional;

/** Collects corners and triangles of a mesh. */
final class MeshBuilder {
  private static final int FLOAT = 4;

  private float[] xyz = new float[96];
  private float[] normals = new float[96];
  private int[] colors = new int[32];
  private int[] triangles = new int[96];
  private int corners;
  private int indices;
  private Optional<Rgba> color = Optional.empty();

  /** Colours the corners that follow. Once one corner has a colour, all must. */
  MeshBuilder color(Rgba next) {
    color = Optional.of(next);
    return this;
  }

  /** Adds a corner; the normal is brought to unit length. Answers its index. */
  int corner(double x, double y, double z, double nx, double ny, double nz) {
    if (3 * corners + 3 > xyz.length) {
      xyz = Arrays.copyOf(xyz, 2 * xyz.length);
      normals = Arrays.copyOf(normals, xyz.length);
      colors = Arrays.copyOf(colors, 2 * colors.length);
    }
    double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    put(xyz, x, y, z);
    put(normals, nx / length, ny / length, nz / length);
    colors[corners] = color.map(Rgba::packed).orElse(0);
    return corners++;
  }

  MeshBuilder triangle(int a, int b, int c) {
    if (indices + 3 > triangles.length) {
      triangles = Arrays.copyOf(triangles, 2 * triangles.length);
    }
    triangles[indices++] = a;
    triangles[indices++] = b;
    triangles[indices++] = c;
    return this;
  }

  /** Two triangles between four corners in turn. */
  MeshBuilder quad(int a, int b, int c, int d) {
    return triangle(a, b, c).triangle(a, c, d);
  }

  TriangleMesh build() {
    FloatBuffer places = direct(xyz, 3 * corners);
    return new TriangleMesh(places, Optional.of(direct(normals, 3 * corners)), Optional.empty(),
        color.map(any -> paint()),
        indices(), Box3.around(places));
  }

  private void put(float[] target, double x, double y, double z) {
    target[3 * corners] = (float) x;
    target[3 * corners + 1] = (float) y;
    target[3 * corners + 2] = (float) z;
  }

  private ByteBuffer paint() {
    ByteBuffer rgba = ByteBuffer.allocateDirect(4 * corners);
    for (int i = 0; i < corners; i++) {
      rgba.putInt(colors[i]);
    }
    return rgba.flip();
  }

  private IntBuffer indices() {
    return ByteBuffer.allocateDirect(FLOAT * indices).order(ByteOrder.nativeOrder()).asIntBuffer()
        .put(triangles, 0, indices).flip();
  }

  private static FloatBuffer direct(float[] numbers, int count) {
    return ByteBuffer.allocateDirect(FLOAT * count).order(ByteOrder.nativeOrder()).asFloatBuffer()
        .put(numbers, 0, count).flip();
  }
}
