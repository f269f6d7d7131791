package org.robotui.gl.internal.splat;

import static org.robotui.gl.internal.splat.Facets.CORNERS;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;
import java.util.Optional;
import org.robotui.gl.shape.TriangleMesh;

/** Collects what differs among the corners of a mesh. */
final class FacetsBuilder {
  private static final int MOST_COLORS = 64;
  private static final int WHITE = 0xffffff;
  private static final int CHANNELS = 4;
  /** Directions that differ by less than half a degree are one: light has no more shades. */
  private static final float NORMAL_STEPS = 64;

  private final FloatBuffer xyz;
  private final Optional<FloatBuffer> given;
  private final Optional<ByteBuffer> rgba;
  private final Welds places = new Welds();
  private final Welds normals = new Welds();
  private final Welds colors = new Welds();
  private final int[] placesOf;
  private final int[] normalsOf;
  private final byte[] colorsOf;
  private final boolean[] outward;
  private int corners;

  FacetsBuilder(TriangleMesh mesh, int most) {
    xyz = mesh.xyz();
    given = mesh.normals();
    rgba = mesh.rgba();
    placesOf = new int[most];
    normalsOf = new int[most];
    colorsOf = new byte[most / CORNERS];
    outward = new boolean[most / CORNERS];
  }

  /** None where there are too many colours. A triangle with a corner that is no number is left out. */
  Optional<Facets> build(IntBuffer triangles) {
    for (int i = 0; i < triangles.remaining() && colors.size() <= MOST_COLORS; i += CORNERS) {
      add(triangles.get(i), triangles.get(i + 1), triangles.get(i + 2));
    }
    if (colors.size() > MOST_COLORS) {
      return Optional.empty();
    }
    return Optional.of(
        new Facets(placeFloats(), normalFloats(), Arrays.copyOf(placesOf, corners), Arrays.copyOf(normalsOf, corners),
            Arrays.copyOf(colorsOf, corners / CORNERS), Arrays.copyOf(outward, corners / CORNERS), palette()));
  }

  private void add(int a, int b, int c) {
    if (isFinite(a) && isFinite(b) && isFinite(c)) {
      double[] own = across(a, b, c);
      colorsOf[corners / CORNERS] = (byte) color(a);
      outward[corners / CORNERS] = given.isEmpty() || along(own, a) + along(own, b) + along(own, c) >= 0;
      for (int corner : new int[]{a, b, c}) {
        int at = CORNERS * corner;
        placesOf[corners] = places.number(bits(xyz.get(at)), bits(xyz.get(at + 1)), bits(xyz.get(at + 2)));
        normalsOf[corners] = given.isPresent() ? normal(given.get(), at) : normal(own[0], own[1], own[2]);
        corners++;
      }
    }
  }

  /** How far the normal of a corner points in a direction. */
  private double along(double[] direction, int corner) {
    double sum = 0;
    for (int axis = 0; axis < CORNERS; axis++) {
      sum += direction[axis] * given.get().get(CORNERS * corner + axis);
    }
    return sum;
  }

  private boolean isFinite(int corner) {
    return Float.isFinite(xyz.get(CORNERS * corner) + xyz.get(CORNERS * corner + 1) + xyz.get(CORNERS * corner + 2));
  }

  /** The bits of a number; of both zeros those of one. */
  private static int bits(float number) {
    return Float.floatToRawIntBits(number + 0f);
  }

  private int color(int corner) {
    return colors.number(rgba.map(bytes -> rgb(bytes, CHANNELS * corner)).orElse(WHITE), 0, 0);
  }

  private static int rgb(ByteBuffer bytes, int at) {
    return (bytes.get(at) & 0xff) << 16 | (bytes.get(at + 1) & 0xff) << 8 | bytes.get(at + 2) & 0xff;
  }

  private int normal(FloatBuffer from, int at) {
    return normal(from.get(at), from.get(at + 1), from.get(at + 2));
  }

  private int normal(double x, double y, double z) {
    return normals.number((int) Math.round(x * NORMAL_STEPS), (int) Math.round(y * NORMAL_STEPS),
        (int) Math.round(z * NORMAL_STEPS));
  }

  /** What stands upright on a triangle, of unit length, towards where its corners are seen counterclockwise. */
  private double[] across(int a, int b, int c) {
    double[] u = edge(a, b);
    double[] v = edge(a, c);
    double x = u[1] * v[2] - u[2] * v[1];
    double y = u[2] * v[0] - u[0] * v[2];
    double z = u[0] * v[1] - u[1] * v[0];
    double length = Math.max(Double.MIN_NORMAL, Math.sqrt(x * x + y * y + z * z));
    return new double[]{x / length, y / length, z / length};
  }

  private double[] edge(int from, int to) {
    double[] edge = new double[CORNERS];
    for (int axis = 0; axis < CORNERS; axis++) {
      edge[axis] = (double) xyz.get(CORNERS * to + axis) - xyz.get(CORNERS * from + axis);
    }
    return edge;
  }

  private float[][] placeFloats() {
    float[][] axes = new float[CORNERS][places.size()];
    for (int axis = 0; axis < CORNERS; axis++) {
      for (int i = 0; i < places.size(); i++) {
        axes[axis][i] = Float.intBitsToFloat(places.get(i, axis));
      }
    }
    return axes;
  }

  private float[][] normalFloats() {
    float[][] axes = new float[CORNERS][normals.size()];
    for (int i = 0; i < normals.size(); i++) {
      double length = Math.max(1, Math.hypot(Math.hypot(normals.get(i, 0), normals.get(i, 1)), normals.get(i, 2)));
      for (int axis = 0; axis < CORNERS; axis++) {
        axes[axis][i] = (float) (normals.get(i, axis) / length);
      }
    }
    return axes;
  }

  private int[] palette() {
    int[] palette = new int[colors.size()];
    Arrays.setAll(palette, i -> colors.get(i, 0));
    return palette;
  }
}
