package org.robotui.uic.status.internal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Controls;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.control.QuietButton;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class StatusSwtTest {
  @Test
  void noButtonRunsOverTheEdge() {
    Theme theme = Themes.dark(TestDisplay.get());
    Shell shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    FakeUicContext context = new FakeUicContext("status", new StatusType().schema());
    context.ruic().snapshot(Snapshots.typical());
    context.authority().stop(FakeAuthority.YOU);
    StatusUic uic = new StatusUic(context);
    uic.tick(System.nanoTime());
    Control control = uic.createControl(shell, UiContext.of(theme, note -> {}));
    shell.open();
    for (int width = 240; width < 520; width += 4) {
      shell.setSize(width, 200);
      while (shell.getDisplay().readAndDispatch()) {
        Thread.onSpinWait();
      }
      within(control, width);
    }
    shell.dispose();
    theme.dispose();
  }

  private static void within(Control control, int width) {
    for (QuietButton button : Controls.all(control, QuietButton.class)) {
      Composite bar = button.getParent();
      int end = button.getLocation().x + button.getSize().x;
      assertTrue(!button.isVisible() || end <= bar.getSize().x,
          () -> button.getToolTipText() + " ends at " + end + " in a view of " + width);
    }
  }
}
