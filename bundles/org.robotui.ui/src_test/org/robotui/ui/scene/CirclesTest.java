package org.robotui.ui.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.LineAttributes;
import org.eclipse.swt.graphics.Path;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class CirclesTest {
  private static final int EDGE = 120;
  private static final double MIDDLE = 57.3;
  /** The toolkit moves lines of an odd width by half a pixel. */
  private static final float WIDTH = 2;
  /** What a pixel at the edge may differ, of 255: the toolkit makes its lines of corners, too, and of fewer. */
  private static final int SLIGHT = 80;

  private final Display display = TestDisplay.get();

  private interface Drawing {
    void draw(GC gc);
  }

  private byte[] drawn(Drawing drawing) {
    Image image = new Image(display, EDGE, EDGE);
    GC gc = new GC(image);
    gc.setAdvanced(true);
    gc.setAntialias(SWT.ON);
    gc.setBackground(display.getSystemColor(SWT.COLOR_BLACK));
    gc.setLineAttributes(new LineAttributes(WIDTH));
    drawing.draw(gc);
    gc.dispose();
    byte[] bytes = image.getImageData().data;
    image.dispose();
    return bytes;
  }

  private static int mostApart(byte[] one, byte[] other) {
    int most = 0;
    for (int i = 0; i < one.length; i++) {
      most = Math.max(most, Math.abs((one[i] & 0xff) - (other[i] & 0xff)));
    }
    return most;
  }

  private Path arc(double radius) {
    Path path = new Path(display);
    path.addArc((float) (MIDDLE - radius), (float) (MIDDLE - radius), (float) (2 * radius), (float) (2 * radius), 0,
        360);
    path.close();
    return path;
  }

  private static void filled(GC gc, Path path) {
    gc.fillPath(path);
    path.dispose();
  }

  private static void stroked(GC gc, Path path) {
    gc.drawPath(path);
    path.dispose();
  }

  @Test
  void theyLookAsTheToolkitsOwn() {
    for (double radius : new double[]{4.5, 9, 33, 2}) {
      byte[] disc = drawn(gc -> filled(gc, Circles.disc(display, MIDDLE, MIDDLE, radius)));
      assertTrue(mostApart(disc, drawn(gc -> filled(gc, arc(radius)))) <= SLIGHT, "disc of " + radius);
      byte[] ring = drawn(gc -> filled(gc, Circles.ring(display, MIDDLE, MIDDLE, radius, WIDTH)));
      assertTrue(mostApart(ring, drawn(gc -> stroked(gc, arc(radius)))) <= SLIGHT,
          "ring of " + radius + ": " + mostApart(ring, drawn(gc -> stroked(gc, arc(radius)))));
    }
  }

  @Test
  void aRingWiderThanItsCircleIsADisc() {
    byte[] ring = drawn(gc -> filled(gc, Circles.ring(display, MIDDLE, MIDDLE, 1, 6)));
    assertEquals(0, mostApart(ring, drawn(gc -> filled(gc, Circles.disc(display, MIDDLE, MIDDLE, 4)))));
  }

  @Test
  void largeOnesHaveMoreCornersAndAllHaveSome() {
    assertTrue(Circles.corners(100) > Circles.corners(10));
    assertEquals(8, Circles.corners(0));
    assertEquals(1000, Circles.corners(1e9));
  }
}
