package org.robotui.uic.camera.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.PaletteData;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class ScreenTest {
  private final ImageData first = picture(2);
  private final ImageData second = picture(3);
  private Display display;
  private Screen screen;

  private static ImageData picture(int width) {
    return new ImageData(width, 2, 24, new PaletteData(0xff0000, 0xff00, 0xff));
  }

  @BeforeEach
  void open() {
    display = TestDisplay.get();
    screen = new Screen(display);
  }

  @AfterEach
  void close() {
    screen.dispose();
  }

  private void prepareElsewhere(ImageData pixels) throws InterruptedException {
    Thread.ofPlatform().start(() -> screen.prepare(pixels)).join();
  }

  @Test
  void whatTheTickMadeReadyIsPaintedAndKept() throws InterruptedException {
    prepareElsewhere(first);
    Image image = screen.image(first);
    assertEquals(2, image.getBounds().width);
    assertSame(image, screen.image(first));
    prepareElsewhere(second);
    assertSame(image, screen.image(first), "the next one waits until it is shown");
    assertEquals(3, screen.image(second).getBounds().width);
    assertTrue(image.isDisposed());
  }

  @Test
  void aNewerPictureOfTheSameSizeIsShownInPlaceOfOneThatIsGone() throws InterruptedException {
    ImageData newer = picture(2);
    prepareElsewhere(first);
    prepareElsewhere(newer);
    Image image = screen.image(first);
    assertSame(image, screen.image(newer), "it was shown already");
    assertSame(image, screen.image(newer));
    assertFalse(image.isDisposed());
  }

  @Test
  void whatWasNotMadeReadyIsMadeWhenItIsPainted() {
    assertEquals(3, screen.image(second).getBounds().width);
  }

  @Test
  void afterTheEndNothingIsHeld() throws InterruptedException {
    prepareElsewhere(first);
    Image image = screen.image(first);
    screen.dispose();
    prepareElsewhere(second);
    assertTrue(image.isDisposed());
    assertFalse(display.isDisposed());
  }
}
