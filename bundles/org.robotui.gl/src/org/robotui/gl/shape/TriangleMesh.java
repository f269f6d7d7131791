package org.robotui.gl.shape;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;

/**
 * A surface of triangles, seen from both sides.
 *
 * @param xyz x, y, z of the corners in turn, metres
 * @param normals x, y, z of unit length a corner, for lit materials; empty where the renderer shall take each
 * triangle's own
 * @param uv u, v a corner, 0 to 1 from the first row of the texture's pixels; empty without a texture
 * @param rgba four bytes red, green, blue, alpha a corner; empty where the material colours all
 * @param triangles three indices of corners each
 * @param bounds where it lies
 */
public record TriangleMesh(
    FloatBuffer xyz,
    Optional<FloatBuffer> normals,
    Optional<FloatBuffer> uv,
    Optional<ByteBuffer> rgba,
    IntBuffer triangles,
    Optional<Box3> bounds)
    implements Shape {
  /**
   * Checks sizes and indices, so that the graphics card never reads outside.
   *
   * @param xyz the corners
   * @param normals their normals
   * @param uv their places in the texture
   * @param rgba their colours
   * @param triangles three indices each
   * @param bounds where it lies
   */
  public TriangleMesh {
    xyz = xyz.slice();
    Triples.check(xyz, "corners");
    int count = xyz.remaining() / 3;
    normals = normals.map(FloatBuffer::slice);
    normals.ifPresent(n -> Triples.fit(n, count, 3, "normals"));
    uv = uv.map(FloatBuffer::slice);
    uv.ifPresent(places -> Triples.fit(places, count, 2, "places in the texture"));
    rgba = rgba.map(ByteBuffer::slice);
    rgba.ifPresent(colors -> Colors.fit(colors, count));
    triangles = triangles.slice();
    checkIndices(triangles, count);
  }

  /**
   * A surface of one colour, with its bounds computed.
   *
   * @param xyz the corners
   * @param normals their normals
   * @param triangles three indices each
   * @return the shape
   */
  public static TriangleMesh of(FloatBuffer xyz, Optional<FloatBuffer> normals, IntBuffer triangles) {
    return new TriangleMesh(xyz, normals, Optional.empty(), Optional.empty(), triangles, Box3.around(xyz));
  }

  private static void checkIndices(IntBuffer triangles, int count) {
    if (triangles.remaining() % 3 != 0) {
      throw new IllegalArgumentException("triangles: " + triangles.remaining() + " indices, must be three each");
    }
    for (int i = 0; i < triangles.remaining(); i++) {
      int index = triangles.get(i);
      if (index < 0 || index >= count) {
        throw new IllegalArgumentException("triangle " + i / 3 + ": corner " + index + " of " + count);
      }
    }
  }

  @Override
  public int elements() {
    return triangles.remaining() / 3;
  }

  @Override
  public long bytes() {
    long numbers =
        xyz.remaining() + normals.map(FloatBuffer::remaining).orElse(0) + uv.map(FloatBuffer::remaining).orElse(0);
    return 4L * (numbers + triangles.remaining()) + rgba.map(ByteBuffer::remaining).orElse(0);
  }
}
