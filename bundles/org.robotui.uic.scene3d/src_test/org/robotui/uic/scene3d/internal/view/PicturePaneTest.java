package org.robotui.uic.scene3d.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.gl.render.Rendered;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.uic.scene3d.internal.camera.CameraPose;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class PicturePaneTest {
  private static final int WIDTH = 1300;
  private static final int HEIGHT = 211;

  private final Display display = TestDisplay.get();
  private final PicturePane pane = new PicturePane(display);

  @AfterEach
  void end() {
    pane.dispose();
  }

  private static Rendered.Picture picture(int width, int height, int... rgb) {
    return new Rendered.Picture(width, height, rgb, new Rendered.Figures(0, 0, 0, 0, 0, 0, 0), List.of());
  }

  private void take(int color, int width, int height) {
    int[] rgb = new int[width * height];
    Arrays.fill(rgb, color);
    pane.take(picture(width, height, rgb), CameraPose.START);
    Arrays.fill(rgb, 0); // what was copied is not read again
  }

  private ImageData painted(int width, int height) {
    Image target = new Image(display, width, height);
    GC gc = new GC(target);
    PicturePane.paint(gc, new Rectangle(0, 0, width, height), pane.newest().orElseThrow().image());
    gc.dispose();
    ImageData data = target.getImageData();
    target.dispose();
    return data;
  }

  /** Colours that are told apart. */
  private static int[] colours() {
    int[] rgb = new int[WIDTH * HEIGHT];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = i * 7919 & 0xffffff;
    }
    return rgb;
  }

  @Test
  void eachPixelIsWhereItWas() {
    int[] rgb = colours();
    pane.take(picture(WIDTH, HEIGHT, rgb), CameraPose.START);
    ImageData data = painted(WIDTH, HEIGHT);
    for (int i = 0; i < rgb.length; i += 13) {
      assertEquals(rgb[i], rgb(data, i % WIDTH, i / WIDTH), "pixel " + i);
    }
  }

  @Test
  void inAWindowOfAnotherSizeItLiesInTheMiddleAsLargeAsItWas() {
    int[] rgb = colours();
    int narrower = 110;
    int higher = 46;
    pane.take(picture(WIDTH, HEIGHT, rgb), CameraPose.START);
    ImageData data = painted(WIDTH - narrower, HEIGHT + higher);
    for (int i = 0; i < data.width * HEIGHT; i += 13) {
      int x = i % data.width;
      int y = i / data.width;
      assertEquals(rgb[y * WIDTH + x + narrower / 2], rgb(data, x, y + higher / 2), "pixel " + x + ", " + y);
    }
    assertEquals(0xffffff, rgb(data, 500, 3), "above it");
    assertEquals(0xffffff, rgb(data, 500, data.height - 3), "below it");
  }

  @Test
  void eachOfManyPicturesIsTheOneThatIsSeen() {
    for (int color = 0; color < 0xffffff; color += 0x0f1357) {
      take(color, 40, 30);
      assertEquals(color, rgb(painted(40, 30), 39, 29));
    }
  }

  @Test
  void whatWasNotPaintedInTimeIsLeftOut() {
    take(1, 40, 30);
    take(2, 40, 30);
    take(3, 40, 30);
    assertEquals(3, rgb(painted(40, 30), 0, 0));
    assertEquals(3, rgb(painted(40, 30), 0, 0), "it stays until another one comes");
  }

  @Test
  void aPictureOfAnotherSizeIsNotWrittenIntoAnOldImage() {
    for (int edge : new int[]{40, 60, 20, 60}) {
      take(0x102030 + edge, edge, edge);
      assertEquals(0x102030 + edge, rgb(painted(edge, edge), edge - 1, edge - 1));
    }
  }

  @Test
  void afterItsEndItTakesNoMore() {
    take(1, 40, 30);
    pane.dispose();
    take(2, 40, 30);
    assertTrue(pane.newest().isEmpty());
  }

  private static int rgb(ImageData data, int x, int y) {
    RGB rgb = data.palette.getRGB(data.getPixel(x, y));
    return rgb.red << 16 | rgb.green << 8 | rgb.blue;
  }
}
