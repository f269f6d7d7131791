package org.robotui.workbench.internal.pane;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Shell;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

import org.robotui.ui.control.QuietButton;

/**
 * What our windows over another one have in common: their look, their place, their buttons, and Esc, which closes them.
 */
final class DialogShell {
  static final int BUTTON_HEIGHT = 30;
  /** What stays to be seen of the window below. */
  private static final int MARGIN = 40;
  private static final int TOP_AND_BOTTOM = 60;

  private DialogShell() {}

  /** Makes one that is not shown yet; display thread. */
  static Shell over(Shell parent, Theme theme, String title) {
    return over(parent, theme, title, SWT.RESIZE);
  }

  /** Makes one that is not shown yet, with more style; display thread. */
  static Shell over(Shell parent, Theme theme, String title, int style) {
    Shell shell = new Shell(parent, SWT.DIALOG_TRIM | style);
    shell.setText(title);
    shell.setBackground(theme.color(Role.PANEL));
    shell.addListener(SWT.Traverse, e -> e.doit = e.detail == SWT.TRAVERSE_ESCAPE || e.doit);
    return shell;
  }

  /** In the middle of the window below, smaller where that is small; with {@link SWT#DEFAULT} as high as it needs. */
  static void place(Shell shell, int widest, int highest) {
    Rectangle below = shell.getParent().getBounds();
    int width = Math.min(widest, below.width - MARGIN);
    int height = highest == SWT.DEFAULT ? shell.computeSize(width, SWT.DEFAULT).y
        : Math.min(highest, below.height - TOP_AND_BOTTOM);
    shell.setBounds(below.x + (below.width - width) / 2, below.y + (below.height - height) / 2, width, height);
  }

  static GridLayout layout(int columns, int margin, int rowSpacing) {
    GridLayout layout = new GridLayout(columns, false);
    layout.marginWidth = margin;
    layout.marginHeight = margin / 2;
    layout.horizontalSpacing = 2 * Theme.STEP;
    layout.verticalSpacing = rowSpacing;
    return layout;
  }

  /** At the end of its row. */
  static QuietButton button(Composite parent, Theme theme, Runnable action) {
    QuietButton button = new QuietButton(parent, theme, action);
    GridData data = new GridData(SWT.END, SWT.CENTER, false, false);
    data.heightHint = BUTTON_HEIGHT;
    button.setLayoutData(data);
    return button;
  }
}
