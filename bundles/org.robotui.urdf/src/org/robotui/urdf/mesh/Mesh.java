package org.robotui.urdf.mesh;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.List;
import java.util.Optional;
import org.robotui.urdf.Color;

/**
 * A surface of triangles. The buffers can only be read.
 *
 * @param xyz x, y, z of the corners in turn, metres
 * @param normals x, y, z of unit length a corner
 * @param uv two numbers a corner, from the bottom left of the texture; empty where no part has a texture
 * @param triangles three indices of corners each
 * @param parts what has a surface of its own, in the order of the triangles; no corner belongs to two
 */
public record Mesh(FloatBuffer xyz, FloatBuffer normals, Optional<FloatBuffer> uv, IntBuffer triangles,
    List<Part> parts) {
  /**
   * Makes the buffers read-only and copies the list.
   *
   * @param xyz corners
   * @param normals of the corners
   * @param uv places in the texture
   * @param triangles indices
   * @param parts surfaces
   */
  public Mesh {
    xyz = xyz.asReadOnlyBuffer();
    normals = normals.asReadOnlyBuffer();
    uv = uv.map(FloatBuffer::asReadOnlyBuffer);
    triangles = triangles.asReadOnlyBuffer();
    parts = List.copyOf(parts);
  }

  /**
   * Triangles with one surface.
   *
   * @param firstCorner its first corner
   * @param corners how many corners it has
   * @param firstTriangle its first triangle
   * @param triangles how many triangles it has
   * @param color of its surface, none where the file gives none
   * @param texture the file of a picture, as written; none where there is none
   */
  public record Part(
      int firstCorner, int corners, int firstTriangle, int triangles, Optional<Color> color,
      Optional<String> texture) {}
}
