package org.robotui.uic.scene3d.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.gl.render.Rendered;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class StripsTest {
  private static final int WIDTH = 1300;
  private static final int HEIGHT = 211;

  private final Display display = TestDisplay.get();

  private static Rendered.Picture picture(int... rgb) {
    return new Rendered.Picture(WIDTH, HEIGHT, rgb, new Rendered.Figures(0, 0, 0, 0, 0, 0, 0), List.of());
  }

  private ImageData painted(Rendered.Picture picture, int width, int height) {
    Strips strips = Strips.of(display, picture, 100);
    Arrays.fill(picture.rgb(), 0); // what was copied is not read again
    Image target = new Image(display, width, height);
    GC gc = new GC(target);
    strips.paint(gc, new Rectangle(0, 0, width, height));
    gc.dispose();
    strips.dispose();
    ImageData data = target.getImageData();
    target.dispose();
    return data;
  }

  @Test
  void eachPixelIsWhereItWas() {
    int[] rgb = new int[WIDTH * HEIGHT];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = i * 7919 & 0xffffff;
    }
    ImageData data = painted(picture(rgb.clone()), WIDTH, HEIGHT);
    for (int i = 0; i < rgb.length; i += 13) {
      assertEquals(rgb[i], rgb(data, i % WIDTH, i / WIDTH), "pixel " + i);
    }
  }

  @Test
  void inAWindowOfAnotherSizeItLiesInTheMiddleAsLargeAsItWas() {
    int[] rgb = new int[WIDTH * HEIGHT];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = i * 7919 & 0xffffff;
    }
    int narrower = 110;
    int higher = 46;
    ImageData data = painted(picture(rgb.clone()), WIDTH - narrower, HEIGHT + higher);
    for (int i = 0; i < data.width * HEIGHT; i += 13) {
      int x = i % data.width;
      int y = i / data.width;
      assertEquals(rgb[y * WIDTH + x + narrower / 2], rgb(data, x, y + higher / 2), "pixel " + x + ", " + y);
    }
    assertEquals(0xffffff, rgb(data, 500, 3), "above it");
    assertEquals(0xffffff, rgb(data, 500, data.height - 3), "below it");
  }

  private static int rgb(ImageData data, int x, int y) {
    RGB rgb = data.palette.getRGB(data.getPixel(x, y));
    return rgb.red << 16 | rgb.green << 8 | rgb.blue;
  }
}
