package org.robotui.uic.camera.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class PictureViewTest {
  private static final PictureView FIT = new PictureView(ZoomMode.FIT);
  private static final Stage WIDE = stage(800, 240);
  private static final Stage DOUBLE = stage(640, 480);

  @Test
  void fitKeepsTheAspectAndTheMiddle() {
    assertEquals(new Rectangle(240, 0, 320, 240), bounds(FIT, WIDE));
    assertEquals(new Rectangle(0, 80, 320, 240), bounds(FIT, stage(320, 400)));
  }

  @Test
  void fillLeavesNoRoomAndActualIsAPixelOnAPixel() {
    assertEquals(new Rectangle(0, -180, 800, 600), bounds(new PictureView(ZoomMode.FILL), WIDE));
    assertEquals(new Rectangle(160, 120, 320, 240), bounds(new PictureView(ZoomMode.ACTUAL), DOUBLE));
    Stage sharp = new Stage(new Rectangle(0, 0, 640, 480), 320, 240, 0.5);
    assertEquals(new Rectangle(240, 180, 160, 120), bounds(new PictureView(ZoomMode.ACTUAL), sharp));
  }

  @Test
  void aPixelIsFoundUnderThePointer() {
    Placement at = FIT.in(DOUBLE);
    assertEquals(new Point(0, 0), at.pixel(1, 1));
    assertEquals(new Point(319, 239), at.pixel(639, 479));
    assertEquals(new Point(-1, 0), at.pixel(-1, 0));
  }

  @ParameterizedTest
  @EnumSource(value = ZoomMode.class, names = {"FIT", "FILL"})
  void zoomKeepsWhatIsUnderThePointer(ZoomMode mode) {
    Point pointer = new Point(301, 231);
    PictureView view = new PictureView(mode);
    Point before = view.in(DOUBLE).pixel(pointer.x, pointer.y);
    for (int i = 0; i < 10; i++) {
      view = view.zoomed(1.25, pointer, DOUBLE);
    }
    assertEquals(before, view.in(DOUBLE).pixel(pointer.x, pointer.y));
    assertFalse(view.untouched());
  }

  @Test
  void zoomEndsAtTheWholePictureAndAtTheClosest() {
    PictureView out = new PictureView(ZoomMode.FIT, 2, 0.3, 0.3).zoomed(0.01, new Point(10, 10), WIDE);
    assertEquals(bounds(FIT, WIDE), bounds(out, WIDE));
    assertEquals(64, FIT.zoomed(1e6, new Point(400, 120), WIDE).in(WIDE).scale());
    PictureView small = new PictureView(ZoomMode.ACTUAL).zoomed(0.01, new Point(10, 10), stage(160, 120));
    assertEquals(0.5, small.in(stage(160, 120)).scale());
  }

  @Test
  void panMovesWithTheHandAndEndsAtTheEdge() {
    Stage same = stage(320, 240);
    PictureView view = new PictureView(ZoomMode.FIT, 2, 0.5, 0.5).moved(64, 0, same);
    assertEquals(0.4, view.x(), 1e-9);
    assertEquals(0.25, view.moved(10_000, 0, same).x(), 1e-9);
    assertEquals(0.5, FIT.moved(50, 50, same).x(), "what is seen whole stays in the middle");
  }

  @Test
  void onlyWhatIsSeenIsPainted() {
    Placement near = new PictureView(ZoomMode.FIT, 10, 0.5, 0.5).in(DOUBLE);
    Rectangle seen = near.seen(DOUBLE.area(), 320, 240);
    assertEquals(new Rectangle(144, 108, 32, 24), seen);
    assertEquals(DOUBLE.area(), near.region(seen.x, seen.y, seen.width, seen.height));
  }

  private static Stage stage(int width, int height) {
    return new Stage(new Rectangle(0, 0, width, height), 320, 240, 1);
  }

  private static Rectangle bounds(PictureView view, Stage stage) {
    return view.in(stage).bounds(320, 240);
  }
}
