package org.robotui.workbench.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.testkit.TestDisplay;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class ShortcutsKeyTest {
  private final Display display = TestDisplay.get();
  private final List<String> opened = new ArrayList<>();
  private Shell shell;
  private Composite views;

  @BeforeEach
  void listen() {
    shell = new Shell(display);
    views = new Composite(shell, SWT.NONE);
    ShortcutsKey.listen(views, () -> opened.add("shortcuts"));
  }

  @AfterEach
  void close() {
    shell.dispose();
  }

  @Test
  void theQuestionMarkOpensTheShortcutsFromAView() {
    press(new Canvas(views, SWT.NONE), SWT.SHIFT);

    assertEquals(List.of("shortcuts"), opened);
  }

  @Test
  void inTextInAChordAndOutsideOfTheViewsItIsAKeyLikeOthers() {
    press(new Text(views, SWT.NONE), SWT.SHIFT);
    press(new Canvas(views, SWT.NONE), SWT.CTRL);
    press(new Canvas(shell, SWT.NONE), SWT.SHIFT);

    assertEquals(List.of(), opened);
  }

  private static void press(Control in, int modifiers) {
    Event event = new Event();
    event.character = '?';
    event.stateMask = modifiers;
    in.notifyListeners(SWT.KeyDown, event);
  }
}
