package org.robotui.workbench.internal.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.testkit.Controls;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.workbench.internal.model.SearchEntry;
import org.robotui.workbench.internal.pane.SearchPane;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class AnswerTimesTest {
  private final Display display = TestDisplay.get();
  private final Theme theme = Themes.dark(display);
  private final Shell shell = new Shell(display, SWT.NO_TRIM);
  private final AnswerTimes times = new AnswerTimes(display);

  @AfterEach
  void close() {
    times.close();
    shell.dispose();
    theme.dispose();
  }

  @Test
  void theSearchIsTimedWhenItOpensAndForEachChangeOfItsWords() {
    shell.setSize(800, 600);
    shell.open();
    press();

    SearchPane search = SearchPane.open(shell, theme,
        List.of(new SearchEntry("Robot", "Stop Keira", "F12", () -> {}), new SearchEntry("View", "Map", "", () -> {})));

    TestDisplay.until(() -> times.opening().count() == 1);
    Text field = Controls.all(search, Text.class).getFirst();
    press();
    field.setText("map");
    TestDisplay.until(() -> times.answering().count() == 1);
    search.redraw();
    search.update();
    assertEquals(1, times.opening().count());
    assertEquals(1, times.answering().count());
  }

  private void press() {
    shell.notifyListeners(SWT.KeyDown, new Event());
  }
}
