package org.robotui.gl.internal.splat;

import org.robotui.gl.shape.Rgba;

/**
 * How the triangles of a mesh are painted, as <code>mesh.frag</code> draws them.
 *
 * @param clipFromShape sixteen numbers, column by column
 * @param eyeFromShape sixteen numbers, column by column; a rotation and a translation, to x ahead, y to the left, z up
 * @param up x, y, z of what is up, seen from the eye
 * @param lit in light
 * @param tint multiplies the colours
 * @param glow mixed into them, as much as its alpha says
 * @param near depth of the nearest
 * @param far depth of the farthest
 * @param hideBacks whether triangles that face away are left out
 */
public record FacetBrush(float[] clipFromShape, float[] eyeFromShape, float[] up, boolean lit, Rgba tint, Rgba glow,
    float near,
    float far, boolean hideBacks) {
  /** How many shades a colour has. */
  static final int SHADES = 256;

  private static final float GROUND = 0.42f;
  private static final float SKY = 0.6f;
  private static final float LAMP = 0.45f;
  private static final float DARKEST = GROUND;
  private static final float RANGE = SKY + LAMP - GROUND;
  private static final float[] TO_LAMP = unit(-1, 0.35f, 0.55f);
  private static final int MOST = 255;

  private static float[] unit(float x, float y, float z) {
    float length = (float) Math.sqrt(x * x + y * y + z * z);
    return new float[]{x / length, y / length, z / length};
  }

  /** The shades of each colour of a palette, one after the other: red, green and blue of a pixel. */
  int[] shades(int[] palette) {
    int[] shades = new int[SHADES * palette.length];
    for (int i = 0; i < shades.length; i++) {
      float light = lit ? DARKEST + RANGE * (i % SHADES) / (SHADES - 1) : 1;
      int rgb = palette[i / SHADES];
      shades[i] = channel(rgb >> 16 & MOST, tint.red() * light, glow.red()) << 16
          | channel(rgb >> 8 & MOST, tint.green() * light, glow.green()) << 8
          | channel(rgb & MOST, tint.blue() * light, glow.blue());
    }
    return shades;
  }

  private int channel(int own, float light, float glowing) {
    return Math.round(Math.min(MOST, own * light) * (1 - glow.alpha()) + MOST * glowing * glow.alpha());
  }

  /** Which shade each direction has, where it faces the eye. */
  void lights(Facets facets, byte[] facing, byte[] away) {
    float[] e = eyeFromShape;
    for (int i = 0; i < facets.normalCount(); i++) {
      float nx = facets.normals(0)[i];
      float ny = facets.normals(1)[i];
      float nz = facets.normals(2)[i];
      float x = e[0] * nx + e[4] * ny + e[8] * nz;
      float y = e[1] * nx + e[5] * ny + e[9] * nz;
      float z = e[2] * nx + e[6] * ny + e[10] * nz;
      float upwards = x * up[0] + y * up[1] + z * up[2];
      float lamp = x * TO_LAMP[0] + y * TO_LAMP[1] + z * TO_LAMP[2];
      facing[i] = (byte) shade(upwards, lamp);
      away[i] = (byte) shade(-upwards, -lamp);
    }
  }

  private static int shade(float upwards, float lamp) {
    float light = GROUND + (SKY - GROUND) * (0.5f + 0.5f * upwards) + LAMP * Math.max(0, lamp);
    return Math.round((light - DARKEST) / RANGE * (SHADES - 1));
  }
}
