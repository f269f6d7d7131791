package org.robotui.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import java.util.function.Consumer;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.port.InputState;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class LookSwtTest {
  private static Display display;
  private static Theme theme;

  @BeforeAll
  static void open() {
    display = TestDisplay.get();
    theme = Themes.dark(display);
  }

  @AfterAll
  static void close() {
    theme.dispose();
  }

  @Test
  void dotsDifferByShapeAndNotOnlyByColour() {
    Set<String> shapes = new HashSet<>();
    for (Health health : Health.values()) {
      shapes.add(shape(gc -> HealthDot.paint(gc, theme, health, 10, 10)));
    }
    assertEquals(Health.values().length, shapes.size());
  }

  @Test
  void everyIconDrawsSomethingOfItsOwn() {
    Set<String> shapes = new HashSet<>();
    for (Icon icon : Icon.values()) {
      String drawn = shape(gc -> {
        gc.setForeground(theme.color(Role.TEXT));
        Icons.paint(gc, icon, 2, 2, Icons.SIZE);
      });
      assertTrue(drawn.contains("#"), icon.id());
      shapes.add(drawn);
    }
    assertEquals(Icon.values().length, shapes.size());
  }

  @Test
  void iconsAreFoundByTheNamesThatActionsUse() {
    assertEquals(Icon.FOLLOW, Icon.find("follow").orElseThrow());
    assertTrue(Icon.find("nothing").isEmpty());
  }

  @Test
  void imagesOfIconsAreTransparentAroundTheirStrokes() {
    Image image = Icons.image(display, Icon.TARGET, theme.color(Role.ACCENT));
    ImageData data = image.getImageData();
    image.dispose();
    assertEquals(0, data.getAlpha(0, 0));
    assertTrue(data.getAlpha(8, 2) > 100, "the ring is at the top of the icon");
  }

  @Test
  void namesKeepBeginningAndEnd() {
    Image image = new Image(TestDisplay.get(), 10, 10);
    GC gc = new GC(image);
    String name = "camera/depth/image_raw";
    int whole = gc.textExtent(name).x;
    assertEquals(name, TextFit.inTheMiddle(gc, name, whole));
    String cut = TextFit.inTheMiddle(gc, name, whole / 2);
    assertTrue(cut.startsWith("cam") && cut.endsWith("raw") && gc.textExtent(cut).x <= whole / 2, cut);
    assertEquals("", TextFit.inTheMiddle(gc, name, 0));
    gc.dispose();
    image.dispose();
  }

  @Test
  void fontsHaveFractionsOfPoints() {
    assertEquals(9.375f, theme.font(Face.BODY).getFontData()[0].height, 0.01);
  }

  @Test
  void themesAndStatesLeaveNothingBehind() {
    int before = resources();
    for (String id : Themes.ids()) {
      Theme made = Themes.of(display, id);
      StateView view = new StateView(made);
      shape(gc -> {
        view.paint(gc, new Rectangle(0, 0, 20, 20), new InputState.Failed("refused by the robot"));
        view.paint(gc, new Rectangle(0, 0, 20, 20), new InputState.Stale(2, "old"));
      });
      made.dispose();
    }
    assertEquals(before, resources());
  }

  private static int resources() {
    return display.getDeviceData().objects.length;
  }

  /** What differs from an empty picture, whatever its colour. */
  private static String shape(Consumer<GC> painting) {
    Image image = new Image(display, 20, 20);
    GC gc = new GC(image);
    gc.setBackground(theme.color(Role.PANEL));
    gc.fillRectangle(0, 0, 20, 20);
    painting.accept(gc);
    gc.dispose();
    ImageData data = image.getImageData();
    image.dispose();
    StringBuilder mask = new StringBuilder();
    for (int y = 0; y < 20; y++) {
      for (int x = 0; x < 20; x++) {
        mask.append(data.getPixel(x, y) == data.getPixel(0, 0) ? '.' : '#');
      }
    }
    return mask.toString();
  }
}
