package org.robotui.uic.camera.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.junit.jupiter.api.Test;

class PictureViewTest {
  private static final Rectangle WIDE = new Rectangle(0, 0, 800, 240);

  @Test
  void fitKeepsTheAspectAndTheMiddle() {
    assertEquals(new Rectangle(240, 0, 320, 240), PictureView.FIT.in(WIDE, 320, 240).bounds(320, 240));
    assertEquals(new Rectangle(0, 80, 320, 240), PictureView.FIT.in(new Rectangle(0, 0, 320, 400), 320, 240).bounds(320, 240));
  }

  @Test
  void aPixelIsFoundUnderThePointer() {
    PictureView.Placement at = PictureView.FIT.in(new Rectangle(0, 0, 640, 480), 320, 240);
    assertEquals(new Point(0, 0), at.pixel(1, 1));
    assertEquals(new Point(319, 239), at.pixel(639, 479));
    assertEquals(new Point(-1, 0), at.pixel(-1, 0));
  }

  @Test
  void zoomKeepsWhatIsUnderThePointer() {
    Rectangle area = new Rectangle(0, 0, 640, 480);
    Point pointer = new Point(201, 131);
    PictureView view = PictureView.FIT;
    for (int i = 0; i < 10; i++) {
      view = view.zoomed(1.25, pointer, area, 320, 240);
    }
    assertEquals(new Point(100, 65), view.in(area, 320, 240).pixel(pointer.x, pointer.y));
  }

  @Test
  void zoomEndsAtTheWholePictureAndAtTheClosest() {
    PictureView out = new PictureView(2, 0.3, 0.3).zoomed(0.01, new Point(10, 10), WIDE, 320, 240);
    assertEquals(PictureView.FIT, out);
    assertEquals(64, PictureView.FIT.zoomed(1e6, new Point(400, 120), WIDE, 320, 240).zoom());
  }

  @Test
  void panMovesWithTheHandAndEndsAtTheEdge() {
    Rectangle area = new Rectangle(0, 0, 320, 240);
    PictureView view = new PictureView(2, 0.5, 0.5).moved(64, 0, area, 320, 240);
    assertEquals(0.4, view.x(), 1e-9);
    assertEquals(0.25, view.moved(10_000, 0, area, 320, 240).x(), 1e-9);
  }
}
