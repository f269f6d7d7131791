package org.robotui.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.eclipse.swt.SWTException;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.internal.SurfacePixels;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class LiveImageTest {
  private static final int EDGE = 24;

  private final Display display = TestDisplay.get();

  private RGB painted(LiveImage image) {
    image.changed();
    Image target = new Image(display, EDGE, EDGE);
    GC gc = new GC(target);
    gc.drawImage(image.image(), 0, 0);
    gc.dispose();
    RGB seen = target.getImageData().palette.getRGB(target.getImageData().getPixel(EDGE / 2, EDGE / 2));
    target.dispose();
    image.changed();
    return seen;
  }

  @Test
  void thisToolkitLetsItsPixelsBeWritten() {
    assertTrue(SurfacePixels.find().isPresent(), "else the fast way went with an update of the toolkit");
  }

  @Test
  void showsWhatItWasGivenLast() {
    LiveImage image = new LiveImage(display, EDGE, EDGE, 100);
    int[] rgb = new int[EDGE * EDGE + 5]; // more than it needs is no harm
    for (int color : new int[]{0xff0000, 0x00ff00, 0x0000ff, 0x123456}) {
      Arrays.fill(rgb, color);
      image.set(rgb);
      assertEquals(new RGB(color >> 16, color >> 8 & 0xff, color & 0xff), painted(image));
    }
    image.dispose();
  }

  @Test
  void atAHigherZoomThePixelsAreFinerThanPoints() {
    LiveImage image = new LiveImage(display, 2 * EDGE, 2 * EDGE, 200);
    assertEquals(EDGE, image.width());
    assertEquals(EDGE, image.height());
    image.dispose();
  }

  @Test
  void fitsItsFormAlone() {
    LiveImage image = new LiveImage(display, EDGE, EDGE + 1, 100);
    assertTrue(image.fits(EDGE, EDGE + 1, 100));
    assertFalse(image.fits(EDGE + 1, EDGE, 100));
    assertFalse(image.fits(EDGE, EDGE + 1, 200));
    image.dispose();
  }

  @Test
  void oneThatWasFreedIsNotWritten() {
    LiveImage image = new LiveImage(display, EDGE, EDGE, 100);
    image.dispose();
    assertThrows(SWTException.class, () -> image.set(new int[EDGE * EDGE]));
  }
}
