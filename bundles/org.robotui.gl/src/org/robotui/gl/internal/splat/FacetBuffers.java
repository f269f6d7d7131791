package org.robotui.gl.internal.splat;

/**
 * Where the places of a mesh are in the picture, and how its directions are lit: memory that is used for one mesh after
 * the other.
 */
final class FacetBuffers {
  /** Numbers of a place. */
  static final int STRIDE = 3;
  static final int Y = 1;
  static final int DEPTH = 2;

  /** Bits of a row in the cell of a place, below those of its column: pictures have at most as many rows. */
  static final int ROW_BITS = 16;
  static final int ROW = (1 << ROW_BITS) - 1;

  private float[] pixels = {};
  private int[] cells = {};
  private byte[] facing = {};
  private byte[] opposite = {};
  private int[] away = {};

  /** Makes room. */
  void fit(int places, int normals, int triangles) {
    if (pixels.length < STRIDE * places) {
      pixels = new float[STRIDE * places];
      cells = new int[places];
    }
    if (away.length < triangles) {
      away = new int[triangles];
    }
    if (facing.length < normals) {
      facing = new byte[normals];
      opposite = new byte[normals];
    }
  }

  /**
   * Of each place the pixels from the left, the rows from the top, and the depth as OpenGL keeps it: what is needed
   * together lies together.
   */
  float[] pixels() {
    return pixels;
  }

  /**
   * Of each place the first column and row whose middles are not before it, cut at the edges of the picture. A triangle
   * whose corners have one column, or one row, covers no middle of a pixel: of small ones that is the most.
   */
  int[] cells() {
    return cells;
  }

  /** The shade of a direction that faces the eye. */
  byte[] facing() {
    return facing;
  }

  /** The shade of the opposite direction. */
  byte[] opposite() {
    return opposite;
  }

  /** Triangles that face away, to be painted after the others. */
  int[] away() {
    return away;
  }

  void project(Facets facets, FacetBrush brush, int width, int height) {
    float[] m = brush.clipFromShape();
    float[] px = facets.places(0);
    float[] py = facets.places(1);
    float[] pz = facets.places(2);
    float halfWidth = width / 2f;
    float halfHeight = height / 2f;
    float middle = (brush.far() + brush.near()) / 2;
    float half = (brush.far() - brush.near()) / 2;
    for (int i = 0; i < px.length; i++) {
      float near = 1 / (m[3] * px[i] + m[7] * py[i] + m[11] * pz[i] + m[15]);
      pixels[STRIDE * i] = ((m[0] * px[i] + m[4] * py[i] + m[8] * pz[i] + m[12]) * near + 1) * halfWidth;
      pixels[STRIDE * i + Y] = ((m[1] * px[i] + m[5] * py[i] + m[9] * pz[i] + m[13]) * near + 1) * halfHeight;
      int column = Math.clamp(Splats.firstPixel(pixels[STRIDE * i]), 0, width);
      cells[i] = column << ROW_BITS | Math.clamp(Splats.firstPixel(pixels[STRIDE * i + Y]), 0, height);
      pixels[STRIDE * i + DEPTH] = middle + half * (m[2] * px[i] + m[6] * py[i] + m[10] * pz[i] + m[14]) * near;
    }
  }
}
