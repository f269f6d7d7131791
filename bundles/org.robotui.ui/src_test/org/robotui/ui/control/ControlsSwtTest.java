package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class ControlsSwtTest {
  private static Shell shell;
  private static Theme theme;

  @BeforeAll
  static void open() {
    Display display = TestDisplay.get();
    theme = Themes.light(display);
    shell = new Shell(display);
    shell.setSize(300, 200);
    shell.open();
  }

  @AfterAll
  static void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void aButtonIsPressedByMouseAndKeys() {
    List<String> pressed = new ArrayList<>();
    QuietButton button = new QuietButton(shell, theme, () -> pressed.add("x")).text("Take");
    button.setSize(button.computeSize(SWT.DEFAULT, SWT.DEFAULT));
    send(button, SWT.MouseDown, 1, 5, 5, ' ');
    send(button, SWT.MouseUp, 1, 5, 5, ' ');
    send(button, SWT.KeyDown, 0, 0, 0, SWT.CR);
    assertEquals(2, pressed.size());
  }

  @Test
  void aPressThatEndsOutsideDoesNothing() {
    List<String> pressed = new ArrayList<>();
    QuietButton button = new QuietButton(shell, theme, () -> pressed.add("x")).text("Take");
    button.setSize(50, 28);
    send(button, SWT.MouseDown, 1, 5, 5, ' ');
    send(button, SWT.MouseUp, 1, 90, 5, ' ');
    assertTrue(pressed.isEmpty());
  }

  @Test
  void aDisabledButtonCannotBePressed() {
    List<String> pressed = new ArrayList<>();
    QuietButton button = new QuietButton(shell, theme, () -> pressed.add("x"));
    button.setEnabled(false);
    button.press();
    assertTrue(pressed.isEmpty());
  }

  @Test
  void aToggleShowsWhatItIsTold() {
    QuietButton button = new QuietButton(shell, theme, () -> {}).checked(true);
    assertTrue(button.isChecked());
    assertFalse(button.checked(false).isChecked());
  }

  @Test
  void aBarIsDraggedWithinItsLimits() {
    List<Double> chosen = new ArrayList<>();
    LimitBar bar = new LimitBar(shell, theme, 0.8, chosen::add);
    bar.setSize(200, 20);
    send(bar, SWT.MouseDown, 1, 100, 10, ' ');
    assertEquals(0.4, bar.value(), 1e-9);
    send(bar, SWT.MouseDown, 1, 500, 10, ' ');
    assertEquals(0.8, bar.value(), 1e-9);
    assertEquals(List.of(0.4, 0.8), chosen);
  }

  @Test
  void aValueThatIsOnlyShownIsNotReported() {
    List<Double> chosen = new ArrayList<>();
    LimitBar bar = new LimitBar(shell, theme, 1, chosen::add);
    bar.value(0.3);
    assertTrue(chosen.isEmpty());
  }

  private static void send(Control control, int type, int button, int x, int y, char character) {
    Event event = new Event();
    event.button = button;
    event.x = x;
    event.y = y;
    event.character = character;
    control.notifyListeners(type, event);
  }
}
