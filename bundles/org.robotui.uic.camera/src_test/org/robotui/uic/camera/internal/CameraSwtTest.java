package org.robotui.uic.camera.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.image.PixelEncoding;
import org.robotui.entity.image.ColorMap;
import org.robotui.testkit.Displays;
import org.robotui.testkit.Pictures;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class CameraSwtTest {
  private final Display display = TestDisplay.get();
  private final Theme theme = Themes.dark(display);
  private CameraStage stage;

  @BeforeEach
  void open() {
    stage = new CameraStage(display, theme, 640, 480);
    stage.context.input(CameraType.IMAGE).put(Scenes.depth(PixelEncoding.U16C1, 320, 240));
    stage.open();
  }

  @AfterEach
  void close() {
    stage.close();
    theme.dispose();
  }

  @Test
  void keysChooseColoursRangeAndSizeAndTheyAreKept() {
    stage.key('c');
    stage.key('r');
    stage.key('1');
    stage.key('i');
    CameraOptions options = CameraOptions.of(stage.context.settings().current());
    assertEquals(ColorMap.VIRIDIS, options.rendering().map().orElseThrow());
    assertTrue(options.rendering().range().isPresent());
    assertEquals(ZoomMode.ACTUAL, options.zoom());
    assertFalse(options.readOut());
    stage.key('r');
    assertTrue(CameraOptions.of(stage.context.settings().current()).rendering().range().isEmpty());
  }

  @Test
  void theBarIsPressedOnlyWhileItIsSeen() {
    stage.mouse(SWT.MouseDown, 610, 24);
    assertEquals(ZoomMode.FIT, CameraOptions.of(stage.context.settings().current()).zoom());
    stage.mouse(SWT.MouseMove, 320, 240);
    int x = 628;
    while (x > 320 && CameraOptions.of(stage.context.settings().current()).rendering().range().isEmpty()) {
      x -= 10;
      if (x < 595) {
        stage.mouse(SWT.MouseDown, x, 24);
        stage.mouse(SWT.MouseUp, x, 24);
      }
    }
    assertTrue(x > 320, "the word 'Auto' holds the range");
  }

  @Test
  void theWheelOnTheLegendMovesTheNearerEnd() {
    double before =
        CameraOptions.of(stage.context.settings().current()).rendering().range().map(r -> r.high()).orElse(0.0);
    assertEquals(0.0, before);
    stage.wheel(1, 620, 150);
    assertTrue(CameraOptions.of(stage.context.settings().current()).rendering().range().isPresent());
  }

  @Test
  void closeUpPixelsAreCrisp() {
    stage.context.input(CameraType.IMAGE).put(Pictures.raw(PixelEncoding.MONO8, 2, 1, new byte[]{0, (byte) 200}));
    stage.show();
    stage.show();
    ImageData seen = stage.picture();
    assertEquals(new RGB(0, 0, 0), seen.palette.getRGB(seen.getPixel(310, 240)));
    assertEquals(new RGB(200, 200, 200), seen.palette.getRGB(seen.getPixel(330, 240)));
  }

  @Test
  void aLargePictureIsMadeSmallByTheTickNotByTheDisplay() {
    stage.context.input(CameraType.IMAGE).put(Pictures.room(1920, 1440));
    stage.show();
    stage.show();
    ImageData seen = stage.picture();
    assertEquals(640, seen.width);
    assertTrue(stage.note().startsWith("1920\u00d71440 rgb8"), stage.note());
  }
}
