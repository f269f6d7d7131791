package org.robotui.uic.gps.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.sensor.GpsFix;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class GpsSwtTest {
  private final Display display = TestDisplay.get();
  private final Theme theme = Themes.dark(display);
  private GpsStage stage;

  @BeforeEach
  void open() {
    stage = new GpsStage(display, theme, 600, 400);
    stage.put("base", GpsStage.fix("Keira", GpsFix.Quality.GROUND_AUGMENTED, 42, -71, 0.02));
    stage.open();
  }

  @AfterEach
  void close() {
    stage.close();
    theme.dispose();
  }

  @Test
  void aReceiverIsSeenInTheColourOfItsQuality() {
    assertEquals(theme.color(Role.GOOD).getRGB(), colorAt(300, 200));
    stage.put("base", GpsStage.fix("Keira", GpsFix.Quality.FIX, 42, -71, 0.02));
    stage.tick();
    assertEquals(theme.color(Role.WARNING).getRGB(), colorAt(300, 200));
  }

  @Test
  void aFollowedReceiverStaysInTheMiddleUntilTheHandMovesTheView() {
    stage.key('f');
    assertTrue(options().follow());
    assertTrue(stage.note().startsWith("follow Keira"), stage.note());
    stage.put("base", GpsStage.fix("Keira", GpsFix.Quality.GROUND_AUGMENTED, 42.01, -71.01, 0.02));
    stage.tick();
    assertEquals(theme.color(Role.GOOD).getRGB(), colorAt(300, 200));
    stage.mouse(SWT.MouseDown, 1, 300, 300);
    stage.mouse(SWT.MouseMove, 0, 350, 300);
    stage.mouse(SWT.MouseUp, 1, 350, 300);
    assertFalse(options().follow());
    assertEquals(theme.color(Role.GOOD).getRGB(), colorAt(350, 200));
  }

  @Test
  void aReceiverOfTheListIsFollowedByAClick() {
    stage.put("rover", GpsStage.fix("Rover", GpsFix.Quality.FIX, 42.001, -71, 3));
    stage.tick();
    stage.mouse(SWT.MouseDown, 1, 40, 44);
    stage.mouse(SWT.MouseUp, 1, 40, 44);
    assertTrue(options().follow());
    assertEquals("rover.fix", options().followed());
  }

  @Test
  void aReceiverUnderThePointerSaysWhereItIs() {
    stage.mouse(SWT.MouseMove, 0, 301, 199);
    assertEquals(
        "Receiver  \u00b7  base.fix\nGBAS fix  \u00b10.02\u00a0m\n42.000000\u00b0\u00a0N  71.000000\u00b0\u00a0W",
        stage.canvas().getToolTipText());
    stage.mouse(SWT.MouseMove, 0, 100, 300);
    assertNull(stage.canvas().getToolTipText());
  }

  @Test
  void keysAndActionsSwitchTheRulerAndTheWords() {
    stage.act("measure");
    assertTrue(checked("measure"));
    stage.key(SWT.ESC);
    assertFalse(checked("measure"));
    stage.key('d');
    assertTrue(options().sexagesimal());
  }

  private boolean checked(String id) {
    return stage.uic.actions().stream().filter(a -> a.id().equals(id))
        .anyMatch(a -> a.checked().orElseThrow().getAsBoolean());
  }

  private GpsOptions options() {
    return GpsOptions.of(stage.context.settings().current());
  }

  private RGB colorAt(int x, int y) {
    ImageData picture = stage.picture();
    return picture.palette.getRGB(picture.getPixel(x, y));
  }
}
