package org.robotui.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.PaletteData;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.graphics.Transform;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.internal.PatternLook;

/** It draws what the toolkit draws of the same image. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class ImageFillTest {
  private static final int EDGE = 60;
  private static final int PIXELS = 8;

  private final Display display = TestDisplay.get();

  private Image motley(boolean translucent) {
    ImageData data = new ImageData(PIXELS, PIXELS, 24, new PaletteData(0xff0000, 0xff00, 0xff));
    Random random = new Random(5);
    for (int i = 0; i < PIXELS * PIXELS; i++) {
      data.setPixel(i % PIXELS, i / PIXELS, random.nextInt(0x1000000));
      if (translucent) {
        data.setAlpha(i % PIXELS, i / PIXELS, i % 3 * 127);
      }
    }
    return new Image(display, data);
  }

  private byte[] drawn(Consumer<GC> content, int interpolation) {
    Image target = new Image(display, EDGE, EDGE);
    GC gc = new GC(target);
    gc.setInterpolation(interpolation);
    gc.setAntialias(SWT.OFF);
    content.accept(gc);
    gc.dispose();
    byte[] pixels = target.getImageData().data;
    target.dispose();
    return pixels;
  }

  /** How many bytes differ by more than rounding. */
  private static int wrong(byte[] one, byte[] other) {
    int count = 0;
    for (int i = 0; i < one.length; i++) {
      count += Math.abs((one[i] & 0xff) - (other[i] & 0xff)) > 2 ? 1 : 0;
    }
    return count;
  }

  private int differing(Image image, Rectangle part, float[] place, int interpolation) {
    Transform transform = new Transform(display, place);
    byte[] ours = drawn(gc -> ImageFill.draw(gc, image, part, transform), interpolation);
    byte[] theirs = drawn(gc -> {
      gc.setTransform(transform);
      gc.drawImage(image, part.x, part.y, part.width, part.height, part.x, part.y, part.width, part.height);
    }, interpolation);
    transform.dispose();
    return wrong(ours, theirs);
  }

  @Test
  void thisToolkitTellsHowItsPatternsLook() {
    assertTrue(PatternLook.find().isPresent(), "else the fast way went with an update of the toolkit");
  }

  @Test
  void drawsWhatTheToolkitDraws() {
    Rectangle all = new Rectangle(0, 0, PIXELS, PIXELS);
    for (boolean translucent : new boolean[]{false, true}) {
      Image image = motley(translucent);
      assertEquals(0, differing(image, all, new float[]{1, 0, 0, 1, 7, 9}, SWT.NONE));
      assertEquals(0, differing(image, all, new float[]{5, 0, 0, -5, 4, 50}, SWT.NONE));
      assertEquals(0, differing(image, all, new float[]{4, 2, -2, 4, 20, 3}, SWT.NONE));
      assertEquals(0, differing(image, all, new float[]{0.5f, 0, 0, 0.5f, 3, 3}, SWT.LOW));
      image.dispose();
    }
  }

  @Test
  void drawsAPartIntoAnArea() {
    Image image = motley(false);
    Rectangle part = new Rectangle(2, 3, 4, 3);
    Rectangle area = new Rectangle(10, 5, 40, 45);
    byte[] ours = drawn(gc -> ImageFill.draw(gc, image, part, area), SWT.NONE);
    byte[] theirs = drawn(
        gc -> gc.drawImage(image, part.x, part.y, part.width, part.height, area.x, area.y, area.width, area.height),
        SWT.NONE);
    assertEquals(0, wrong(ours, theirs));
    image.dispose();
  }

  @Test
  void anImageThatIsDimmedIsDrawnSo() {
    Image image = motley(false);
    Rectangle all = new Rectangle(0, 0, PIXELS, PIXELS);
    byte[] dimmed = drawn(gc -> {
      gc.setAlpha(128);
      ImageFill.draw(gc, image, all, new Rectangle(0, 0, EDGE, EDGE));
    }, SWT.NONE);
    byte[] full = drawn(gc -> ImageFill.draw(gc, image, all, new Rectangle(0, 0, EDGE, EDGE)), SWT.NONE);
    assertTrue(wrong(dimmed, full) > EDGE * EDGE);
    image.dispose();
  }
}
