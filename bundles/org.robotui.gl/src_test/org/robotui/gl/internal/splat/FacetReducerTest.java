package org.robotui.gl.internal.splat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.TriangleMesh;

class FacetReducerTest {
  private static final int SIDE = 40;
  private static final double MILLIMETRE = 0.001;

  /** Gives a place of a grid its height, from columns and rows of 0 to 1. */
  private interface Height {
    double at(double x, double y);
  }

  /** A metre of ground, seen from above; its left half has another colour. */
  private static Facets ground(Height height) {
    int row = SIDE + 1;
    FloatBuffer xyz = FloatBuffer.allocate(3 * 6 * SIDE * SIDE);
    ByteBuffer rgba = ByteBuffer.allocate(4 * 6 * SIDE * SIDE);
    for (int cell = 0; cell < SIDE * SIDE; cell++) {
      int at = cell / SIDE * row + cell % SIDE;
      for (int corner : new int[]{at, at + 1, at + row + 1, at, at + row + 1, at + row}) {
        double x = corner % row / (double) SIDE;
        double y = corner / row / (double) SIDE;
        xyz.put((float) x).put((float) y).put((float) height.at(x, y));
        rgba.putInt(cell % SIDE < SIDE / 2 ? 0xff0000ff : 0x00ff00ff);
      }
    }
    int[] indices = new int[6 * SIDE * SIDE];
    for (int i = 0; i < indices.length; i++) {
      indices[i] = i;
    }
    TriangleMesh mesh = new TriangleMesh(xyz.flip(), Optional.empty(), Optional.empty(), Optional.of(rgba.flip()),
        IntBuffer.wrap(indices), Box3.around(xyz));
    return Facets.of(mesh, mesh.triangles()).orElseThrow();
  }

  /** What the triangles of a colour cover, seen from above; those that face down count against it. */
  private static double area(Facets facets, int rgb) {
    double sum = 0;
    for (int triangle = 0; triangle < facets.count(); triangle++) {
      int[] at =
          {facets.placesOf()[3 * triangle], facets.placesOf()[3 * triangle + 1], facets.placesOf()[3 * triangle + 2]};
      float[] x = facets.places(0);
      float[] y = facets.places(1);
      double area = ((x[at[1]] - x[at[0]]) * (y[at[2]] - y[at[0]]) - (x[at[2]] - x[at[0]]) * (y[at[1]] - y[at[0]])) / 2;
      assertTrue(area > 0, "a triangle is turned over");
      sum += facets.palette()[facets.colorOf(triangle)] == rgb ? area : 0;
    }
    return sum;
  }

  @Test
  void whatIsFlatNeedsFewTrianglesAndKeepsItsEdgesAndColours() {
    Facets few = ground((x, y) -> 0).reduced(MILLIMETRE, () -> false);
    assertTrue(few.count() < 4 * SIDE, () -> few.count() + " triangles");
    assertEquals(0.5, area(few, 0xff0000), 1e-6);
    assertEquals(0.5, area(few, 0x00ff00), 1e-6);
  }

  @Test
  void whatIsBentStaysWithinTheTolerance() {
    Height hill = (x, y) -> 0.1 * Math.sin(3 * x) * Math.sin(2 * y);
    Facets all = ground(hill);
    Facets few = all.reduced(MILLIMETRE, () -> false);
    assertTrue(few.count() < all.count() / 3, () -> few.count() + " triangles");
    for (int triangle = 0; triangle < few.count(); triangle++) {
      double x = middle(few, triangle, 0);
      double y = middle(few, triangle, 1);
      assertEquals(hill.at(x, y), middle(few, triangle, 2), 3 * MILLIMETRE);
    }
    assertTrue(few.reduced(4 * MILLIMETRE, () -> false).count() < few.count());
  }

  private static double middle(Facets facets, int triangle, int axis) {
    double sum = 0;
    for (int corner = 0; corner < 3; corner++) {
      sum += facets.places(axis)[facets.placesOf()[3 * triangle + corner]];
    }
    return sum / 3;
  }

  @Test
  void aRidgeIsKept() {
    Facets few = ground((x, y) -> 0.2 * Math.abs(x - 0.5)).reduced(MILLIMETRE, () -> false);
    assertTrue(few.count() < 4 * SIDE, () -> few.count() + " triangles");
    for (int triangle = 0; triangle < few.count(); triangle++) {
      assertEquals(0.2 * Math.abs(middle(few, triangle, 0) - 0.5), middle(few, triangle, 2), 1e-5);
    }
  }

  @Test
  void whatIsGivenUpIsAsItWas() {
    Facets all = ground((x, y) -> 0);
    assertEquals(all.count(), all.reduced(MILLIMETRE, () -> true).count());
  }

  @Test
  void aMeshWithoutTrianglesHasNoneAfterwards() {
    Facets none = Facets
        .of(TriangleMesh.of(FloatBuffer.allocate(0), Optional.empty(), IntBuffer.allocate(0)), IntBuffer.allocate(0))
        .orElseThrow();
    assertEquals(0, none.reduced(1, () -> false).count());
  }
}
