package org.robotui.gl.internal.splat;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.TriangleMesh;

class FacetPainterTest {
  private static final int SIDE = 20;
  private static final int RED = 0xff0000;
  private static final int GREEN = 0x00ff00;
  /** Looks along x at 20 x 20 pixels of 0.1 m: y is to the left, z up, x from 0 to 1 in front. */
  private static final float[] CLIP = {0, 0, 2, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 1};
  private static final float[] EYE = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

  private final Splats splats = new Splats(SIDE, SIDE, false);

  @Test
  void trianglesWithOneEdgeCoverEachPixelOfASquareAndNoOther() {
    paint(square(0.5f, -0.5f, 0.5f), RED, false);
    for (int row = 0; row < SIDE; row++) {
      for (int column = 0; column < SIDE; column++) {
        boolean inside = row >= 5 && row < 15 && column >= 5 && column < 15;
        assertEquals(inside ? RED : 0, at(column, row), column + ", " + row);
      }
    }
  }

  @Test
  void theDepthIsThatOfThePlace() {
    paint(square(0.25f, -0.5f, 0.5f), RED, false);
    assertEquals(0.25f, splats.depth(10 * SIDE + 10), 1e-5f);
    assertEquals(Splats.NOTHING, splats.depth(0));
  }

  @Test
  void whatIsNearerIsSeenInWhateverOrderItIsPainted() {
    paint(square(0.2f, -0.5f, 0.5f), RED, false);
    paint(square(0.7f, -0.9f, 0.9f), GREEN, false);
    assertEquals(RED, at(10, 10));
    assertEquals(GREEN, at(2, 10));
  }

  @Test
  void trianglesThatFaceAwayMayBeLeftOut() {
    TriangleMesh away = mesh(new float[]{0.5f, 0.5f, -0.5f, 0.5f, -0.5f, 0.5f, 0.5f, -0.5f, -0.5f});
    paint(away, RED, true);
    assertEquals(0, at(12, 12));
    paint(away, RED, false);
    assertEquals(RED, at(12, 12));
  }

  @Test
  void aTriangleThatCoversNoMiddleOfAPixelIsNotSeen() {
    paint(square(0.5f, 0.11f, 0.14f), RED, false);
    for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
      assertEquals(Splats.NOTHING, splats.depth(pixel), "pixel " + pixel);
    }
    paint(square(0.5f, 0.11f, 0.16f), RED, false);
    assertEquals(RED, at(8, 8));
  }

  @Test
  void aTriangleOfOnePixelHidesAndIsHidden() {
    paint(square(0.5f, 0.11f, 0.16f), RED, false);
    paint(square(0.7f, 0.11f, 0.16f), GREEN, false);
    assertEquals(RED, at(8, 8));
    paint(square(0.3f, 0.11f, 0.16f), GREEN, false);
    assertEquals(GREEN, at(8, 8));
  }

  @Test
  void whatReachesOverTheEdgeIsCutThere() {
    paint(square(0.5f, -50, 50), RED, false);
    assertEquals(RED, at(0, 0));
    assertEquals(RED, at(SIDE - 1, SIDE - 1));
  }

  @Test
  void aTriangleWithACornerThatIsNoNumberIsLeftOut() {
    TriangleMesh broken = mesh(new float[]{0.5f, 0.5f, -0.5f, 0.5f, -0.5f, -0.5f, 0.5f, Float.NaN, 0.5f});
    assertEquals(0, Facets.of(broken, broken.triangles()).orElseThrow().count());
  }

  @Test
  void cornersOfOnePlaceAreComputedOnce() {
    float[] twice = {0, 0, 0, 0, 1, 0, 0, 0, 1, -0f, 0, 0, 0, 1, 0, 0, 0, -1};
    FloatBuffer xyz = FloatBuffer.wrap(twice);
    Facets facets = Facets
        .of(TriangleMesh.of(xyz, Optional.empty(), IntBuffer.wrap(new int[]{0, 1, 2, 3, 4, 5})),
            IntBuffer.wrap(new int[]{0, 1, 2, 3, 4, 5}))
        .orElseThrow();
    assertEquals(4, facets.placeCount());
    assertEquals(2, facets.normalCount());
  }

  @Test
  void aMeshOfMoreColoursThanAPaletteHoldsIsNotTaken() {
    int count = 100;
    FloatBuffer xyz = FloatBuffer.allocate(9 * count);
    ByteBuffer rgba = ByteBuffer.allocate(12 * count);
    IntBuffer triangles = IntBuffer.allocate(3 * count);
    for (int corner = 0; corner < 3 * count; corner++) {
      xyz.put(corner).put(corner % 2).put(corner % 3);
      rgba.putInt(corner / 3 << 8 | 0xff);
      triangles.put(corner);
    }
    TriangleMesh colorful = new TriangleMesh(xyz.flip(), Optional.empty(), Optional.empty(), Optional.of(rgba.flip()),
        triangles.flip(), Box3.around(xyz));
    assertTrue(Facets.of(colorful, colorful.triangles()).isEmpty());
  }

  private int at(int column, int row) {
    IntBuffer value = IntBuffer.allocate(1);
    splats.values(row * SIDE + column, 1, value);
    return value.get(0);
  }

  private void paint(TriangleMesh mesh, int rgb, boolean hideBacks) {
    FacetBrush brush =
        new FacetBrush(CLIP, EYE, new float[]{0, 0, 1}, false, Rgba.of(rgb), Rgba.of(0).withAlpha(0), 0, 1, hideBacks);
    new FacetPainter(splats, brush, Facets.of(mesh, mesh.triangles()).orElseThrow()).paint(() -> false);
  }

  private static TriangleMesh square(float x, float low, float high) {
    return TriangleMesh.of(FloatBuffer.wrap(new float[]{x, high, low, x, low, low, x, low, high, x, high, high}),
        Optional.empty(),
        IntBuffer.wrap(new int[]{0, 1, 2, 0, 2, 3}));
  }

  private static TriangleMesh mesh(float[] three) {
    return TriangleMesh.of(FloatBuffer.wrap(three), Optional.empty(), IntBuffer.wrap(new int[]{0, 1, 2}));
  }
}
