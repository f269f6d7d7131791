package org.robotui.ui.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ViewportTest {
  private static final double EXACT = 1e-9;
  private final Viewport viewport = new Viewport(2, 3, 50, 800, 600);

  @Test
  void worldYPointsUpAndTheCentreIsInTheMiddle() {
    assertEquals(400, viewport.pixelX(2), EXACT);
    assertEquals(300, viewport.pixelY(3), EXACT);
    assertEquals(250, viewport.pixelY(4), EXACT);
  }

  @Test
  void pixelsAndMetresAreInverse() {
    assertEquals(17.25, viewport.pixelX(viewport.worldX(17.25)), EXACT);
    assertEquals(511.5, viewport.pixelY(viewport.worldY(511.5)), EXACT);
  }

  @Test
  void zoomingKeepsWhatIsUnderThePointer() {
    Viewport closer = viewport.zoomedAt(123, 456, 1.7);
    assertEquals(85, closer.scale(), EXACT);
    assertEquals(viewport.worldX(123), closer.worldX(123), EXACT);
    assertEquals(viewport.worldY(456), closer.worldY(456), EXACT);
  }

  @Test
  void zoomingStopsAtTheLimitsWithoutMoving() {
    Viewport far = viewport.zoomedAt(10, 10, 1e-12);
    assertEquals(Viewport.MIN_SCALE, far.scale(), EXACT);
    assertEquals(viewport.worldX(10), far.worldX(10), 1e-6);
    assertEquals(far.centerX(), far.zoomedAt(10, 10, 0.5).centerX(), 1e-6);
  }

  @Test
  void panningMovesTheContentWithTheHand() {
    Viewport panned = viewport.panned(100, -50);
    assertEquals(viewport.pixelX(2) + 100, panned.pixelX(2), EXACT);
    assertEquals(viewport.pixelY(3) - 50, panned.pixelY(3), EXACT);
  }

  @Test
  void fittingShowsAllWithItsMargin() {
    Viewport fit = viewport.fitting(new Bounds(-10, 0, 30, 5), 20);
    assertEquals(20, fit.pixelX(-10), EXACT);
    assertEquals(780, fit.pixelX(30), EXACT);
    assertTrue(fit.visible().contains(30, 5));
  }

  @Test
  void fittingAPointOrATinyWindowStillGivesAView() {
    assertTrue(viewport.fitting(Bounds.around(1, 1, 0), 20).scale() <= Viewport.MAX_SCALE);
    assertTrue(new Viewport(0, 0, 1, 0, 0).fitting(Bounds.around(0, 0, 5), 48).scale() > 0);
  }

  @Test
  void fittingWhatReachesAnywhereGivesAViewOfSomewhere() {
    double[] edges =
        {Double.NEGATIVE_INFINITY, -Double.MAX_VALUE, -1e300, 0, 1e300, Double.MAX_VALUE, Double.POSITIVE_INFINITY};
    for (double low : edges) {
      for (double high : edges) {
        if (low <= high) {
          Bounds seen = viewport.fitting(new Bounds(low, low, high, high), 20).visible();
          assertTrue(seen.width() > 0 && seen.width() < 1e6, low + " to " + high + " gives " + seen);
        }
      }
    }
  }

  @Test
  void aViewOfNowhereIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Viewport(Double.NaN, 0, 1, 10, 10));
    assertThrows(IllegalArgumentException.class, () -> new Viewport(0, 0, Double.NaN, 10, 10));
  }
}
