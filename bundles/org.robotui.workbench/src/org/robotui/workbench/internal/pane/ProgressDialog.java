package org.robotui.workbench.internal.pane;

import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Shell;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** Says how far something is that takes long, and lets the user end it. It holds up nothing. Display thread only. */
public final class ProgressDialog {
  private static final int WIDTH = 420;

  private final Shell shell;
  private final ShortenedLabel label;
  private final Runnable cancel;
  private boolean over;

  /**
   * Makes the window.
   *
   * @param parent the window below
   * @param theme colours and fonts
   * @param title what is done
   * @param cancel is run when the user wants it to end
   */
  public ProgressDialog(Shell parent, Theme theme, String title, Runnable cancel) {
    this.cancel = cancel;
    shell = DialogShell.over(parent, theme, title);
    shell.setLayout(DialogShell.layout(2, 2 * Theme.EDGE, Theme.STEP));
    label = new ShortenedLabel(shell, theme, Face.BODY, Role.TEXT, " ");
    label.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    DialogShell.button(shell, theme, this::end).text("Cancel");
    shell.addListener(SWT.Dispose, e -> end());
    DialogShell.place(shell, WIDTH, SWT.DEFAULT);
  }

  /** Shows it. */
  public void open(String words) {
    show(words);
    shell.open();
  }

  /** Says how far it is. */
  public void show(String words) {
    if (!shell.isDisposed()) {
      label.show(Role.TEXT, words);
    }
  }

  /** What takes long has ended. */
  public void close() {
    over = true;
    shell.dispose();
  }

  private void end() {
    if (!over) {
      over = true;
      cancel.run();
    }
  }
}
