package org.robotui.workbench.internal.pane;

import java.nio.file.Path;
import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Shell;
import org.robotui.ui.Theme;

/** The page of what one can begin with, over a window that shows a robot. Display thread only. */
public final class WelcomeDialog {
  private static final int WIDTH = 680;

  private final Shell shell;
  private final WelcomePane pane;

  /** Makes the window; what was chosen in it closes it. */
  public WelcomeDialog(Shell parent, Theme theme, List<Path> recent, boolean wanted, WelcomePane.Actions actions) {
    shell = DialogShell.over(parent, theme, "Welcome", SWT.NONE);
    shell.setLayout(new FillLayout());
    pane = new WelcomePane(shell, theme, recent, wanted, new Closing(shell, actions));
    DialogShell.place(shell, WIDTH, SWT.DEFAULT);
  }

  /** Shows it. */
  public void open() {
    shell.open();
    pane.setFocus();
  }

  /** Closes the window before what was chosen opens another one. */
  private record Closing(Shell shell, WelcomePane.Actions actions) implements WelcomePane.Actions {
    private void then(Runnable action) {
      shell.close();
      action.run();
    }

    @Override
    public void demo() {
      then(actions::demo);
    }

    @Override
    public void create() {
      then(actions::create);
    }

    @Override
    public void open() {
      then(actions::open);
    }

    @Override
    public void recording() {
      then(actions::recording);
    }

    @Override
    public void open(Path file) {
      then(() -> actions.open(file));
    }

    @Override
    public void software() {
      then(actions::software);
    }

    @Override
    public void documentation() {
      actions.documentation();
    }

    @Override
    public void tutorial() {
      actions.tutorial();
    }

    @Override
    public void wanted(boolean wanted) {
      actions.wanted(wanted);
    }
  }
}
