package org.robotui.gl.internal.splat;

import static org.robotui.gl.internal.splat.FacetBuffers.DEPTH;
import static org.robotui.gl.internal.splat.FacetBuffers.ROW;
import static org.robotui.gl.internal.splat.FacetBuffers.ROW_BITS;
import static org.robotui.gl.internal.splat.FacetBuffers.STRIDE;
import static org.robotui.gl.internal.splat.FacetBuffers.Y;
import static org.robotui.gl.internal.splat.Facets.CORNERS;

import java.util.function.BooleanSupplier;

/**
 * Paints the triangles of a mesh. Where OpenGL is software, triangles of a few pixels take ten times as long there. All
 * places must lie between the near and the far end of what is seen.
 */
public final class FacetPainter {
  private static final int PIECE = 1 << 14;
  /** Pixels. */
  private static final int FEW = 16;
  /** Two triangles with one edge leave no pixel between them, whatever rounding does. */
  private static final float OUTSIDE = -1e-4f;

  private final Splats splats;
  private final FacetBrush brush;
  private final Facets facets;
  private final FacetBuffers buffers;
  private final int[] shades;

  /**
   * Takes what it paints with.
   *
   * @param splats to write into; not for picking
   * @param brush how
   * @param facets what
   */
  public FacetPainter(Splats splats, FacetBrush brush, Facets facets) {
    this.splats = splats;
    this.brush = brush;
    this.facets = facets;
    buffers = splats.buffers(facets);
    shades = brush.shades(facets.palette());
  }

  /**
   * Paints.
   *
   * @param givenUp asked between pieces: whether the rest is wanted no more
   */
  public void paint(BooleanSupplier givenUp) {
    splats.use();
    buffers.project(facets, brush, splats.width(), splats.height());
    brush.lights(facets, buffers.facing(), buffers.opposite());
    int away = 0;
    for (int first = 0; first < facets.count() && !givenUp.getAsBoolean(); first += PIECE) {
      int end = Math.min(facets.count(), first + PIECE);
      for (int triangle = first; triangle < end; triangle++) {
        if (covers(triangle) && !paintFacing(triangle) && !brush.hideBacks()) {
          buffers.away()[away++] = triangle;
        }
      }
    }
    for (int i = 0; i < away && !givenUp.getAsBoolean(); i++) {
      paint(buffers.away()[i]);
    }
  }

  /** Whether a triangle may cover the middle of a pixel. */
  private boolean covers(int triangle) {
    int at = CORNERS * triangle;
    int[] cells = buffers.cells();
    int a = cells[facets.placesOf()[at]];
    int apart = a ^ cells[facets.placesOf()[at + 1]] | a ^ cells[facets.placesOf()[at + 2]];
    return (apart & ROW) != 0 && apart >>> ROW_BITS != 0;
  }

  /** Paints a triangle that faces the eye; answers false for another one, which is likely to be hidden by those. */
  private boolean paintFacing(int triangle) {
    boolean facing = area(triangle) < 0;
    if (facing) {
      paint(triangle);
    }
    return facing;
  }

  /**
   * Twice as many square pixels as it covers. Rows go down: what is counterclockwise to the eye has an area below 0.
   */
  private float area(int triangle) {
    int at = CORNERS * triangle;
    float[] p = buffers.pixels();
    int a = STRIDE * facets.placesOf()[at];
    int b = STRIDE * facets.placesOf()[at + 1];
    int c = STRIDE * facets.placesOf()[at + 2];
    return (p[b] - p[a]) * (p[c + Y] - p[a + Y]) - (p[c] - p[a]) * (p[b + Y] - p[a + Y]);
  }

  private void paint(int triangle) {
    float area = area(triangle);
    int at = CORNERS * triangle;
    int a = facets.placesOf()[at];
    int b = facets.placesOf()[at + 1];
    int c = facets.placesOf()[at + 2];
    int cellA = buffers.cells()[a];
    int cellB = buffers.cells()[b];
    int cellC = buffers.cells()[c];
    int left = Math.min(cellA, Math.min(cellB, cellC)) >>> ROW_BITS;
    int right = Math.max(cellA, Math.max(cellB, cellC)) >>> ROW_BITS;
    int top = Math.min(cellA & ROW, Math.min(cellB & ROW, cellC & ROW));
    int bottom = Math.max(cellA & ROW, Math.max(cellB & ROW, cellC & ROW));
    // What is no number has no area, and is left out as well.
    if ((area < 0 || area > 0) && !isHidden(nearest(STRIDE * a, STRIDE * b, STRIDE * c), left, top, right, bottom)) {
      byte[] lights = area < 0 == facets.isOutward(triangle) ? buffers.facing() : buffers.opposite();
      fill(triangle, lights, STRIDE * a, STRIDE * b, STRIDE * c, 1 / area, left, top, right, bottom);
    }
  }

  private float nearest(int a, int b, int c) {
    float[] p = buffers.pixels();
    return Math.max(0, Math.min(p[a + DEPTH], Math.min(p[b + DEPTH], p[c + DEPTH])));
  }

  /**
   * Whether a depth lies behind all that is seen in some pixels, where these are few: then it is quicker to look than
   * to compute the triangle.
   */
  private boolean isHidden(float nearest, int left, int top, int right, int bottom) {
    boolean hidden = (right - left) * (bottom - top) <= FEW;
    long cell = Splats.cell(nearest, 0);
    for (int row = top; row < bottom && hidden; row++) {
      for (int column = left; column < right && hidden; column++) {
        hidden = cell > splats.cells()[row * splats.width() + column];
      }
    }
    return hidden;
  }

  /** Fills the pixels whose middle lies in it: its three weights there are not negative. */
  private void fill(int triangle, byte[] lights, int a, int b, int c, float perArea, int left, int top, int right,
      int bottom) {
    float[] p = buffers.pixels();
    float x = left + 0.5f;
    float y = top + 0.5f;
    float rowA = ((p[b] - x) * (p[c + Y] - y) - (p[c] - x) * (p[b + Y] - y)) * perArea;
    float rowB = ((p[c] - x) * (p[a + Y] - y) - (p[a] - x) * (p[c + Y] - y)) * perArea;
    float acrossA = (p[b + Y] - p[c + Y]) * perArea;
    float acrossB = (p[c + Y] - p[a + Y]) * perArea;
    float downA = (p[c] - p[b]) * perArea;
    float downB = (p[a] - p[c]) * perArea;
    float deepC = p[c + DEPTH];
    float deepA = p[a + DEPTH] - deepC;
    float deepB = p[b + DEPTH] - deepC;
    int first = FacetBrush.SHADES * facets.colorOf(triangle);
    int at = CORNERS * triangle;
    int lightC = lights[facets.normalsOf()[at + 2]] & 0xff;
    int lightA = (lights[facets.normalsOf()[at]] & 0xff) - lightC;
    int lightB = (lights[facets.normalsOf()[at + 1]] & 0xff) - lightC;
    long[] cells = splats.cells();
    for (int row = top * splats.width(); row < bottom * splats.width(); row += splats.width()) {
      float inA = rowA;
      float inB = rowB;
      for (int pixel = row + left; pixel < row + right; pixel++) {
        if (inA >= OUTSIDE && inB >= OUTSIDE && inA + inB <= 1 - OUTSIDE) {
          float deep = Math.max(0, deepC + inA * deepA + inB * deepB);
          int shade = Math.clamp((int) (lightC + inA * lightA + inB * lightB + 0.5f), 0, FacetBrush.SHADES - 1);
          cells[pixel] = Math.min(cells[pixel], Splats.cell(deep, shades[first + shade]));
        }
        inA += acrossA;
        inB += acrossB;
      }
      rowA += downA;
      rowB += downB;
    }
  }
}
