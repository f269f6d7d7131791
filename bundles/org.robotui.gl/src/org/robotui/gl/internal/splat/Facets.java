package org.robotui.gl.internal.splat;

import java.nio.IntBuffer;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.robotui.gl.shape.TriangleMesh;

/**
 * Triangles of a mesh as the processor paints them: every place and every direction is kept once, so that it is
 * computed once a picture, and a triangle has one colour. Coordinates lie in arrays of their own, which the virtual
 * machine computes several at a time.
 */
public final class Facets {
  static final int CORNERS = 3;

  private final float[][] places;
  private final float[][] normals;
  private final int[] placesOf;
  private final int[] normalsOf;
  private final byte[] colorsOf;
  private final boolean[] outward;
  private final int[] palette;

  Facets(float[][] places, float[][] normals, int[] placesOf, int[] normalsOf, byte[] colorsOf, boolean[] outward,
      int[] palette) {
    this.places = places;
    this.normals = normals;
    this.placesOf = placesOf;
    this.normalsOf = normalsOf;
    this.colorsOf = colorsOf;
    this.outward = outward;
    this.palette = palette;
  }

  /**
   * Takes some milliseconds for a hundred thousand triangles.
   *
   * @param mesh a surface; alpha of its colours does not count
   * @param triangles three indices of its corners each
   * @return its triangles, or none where they have too many colours
   */
  public static Optional<Facets> of(TriangleMesh mesh, IntBuffer triangles) {
    return new FacetsBuilder(mesh, triangles.remaining()).build(triangles);
  }

  /**
   * Merges places with neighbours. Takes about a second for a hundred thousand triangles.
   *
   * @param tolerance by which the surface may move; metres
   * @param givenUp asked now and then: whether nobody waits for it
   * @return the same surface of fewer triangles
   */
  public Facets reduced(double tolerance, BooleanSupplier givenUp) {
    return FacetReducer.reduced(this, tolerance, givenUp);
  }

  /**
   * Triangles.
   *
   * @return the count
   */
  public int count() {
    return colorsOf.length;
  }

  int placeCount() {
    return places[0].length;
  }

  int normalCount() {
    return normals[0].length;
  }

  /** Coordinates of all places along an axis. */
  float[] places(int axis) {
    return places[axis];
  }

  /** Coordinates of all directions along an axis, of unit length. */
  float[] normals(int axis) {
    return normals[axis];
  }

  /** Three numbers of places a triangle. */
  int[] placesOf() {
    return placesOf;
  }

  /** Three numbers of directions a triangle. */
  int[] normalsOf() {
    return normalsOf;
  }

  /** Which colour of the palette a triangle has. */
  int colorOf(int triangle) {
    return colorsOf[triangle];
  }

  /** Whether its directions point to where its corners are seen counterclockwise. */
  boolean isOutward(int triangle) {
    return outward[triangle];
  }

  /** Red, green and blue of each colour. */
  int[] palette() {
    return palette;
  }
}
