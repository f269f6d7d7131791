package org.robotui.workbench.internal.timeline;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.NoticeLine;

/** The frame of a window that stays open beside the views, above the bar of the timeline. Display thread only. */
final class BesideShell {
  private static final int MARGIN = 24;

  private final Control over;
  private final Theme theme;
  private final Shell shell;

  /** Over the window of a control. */
  BesideShell(Control over, Theme theme, String title) {
    this.over = over;
    this.theme = theme;
    shell = new Shell(over.getShell(), SWT.DIALOG_TRIM | SWT.RESIZE | SWT.MODELESS);
    shell.setText(title);
    shell.setBackground(theme.color(Role.PANEL));
    shell.setLayout(layout(1, 0));
    shell.addListener(SWT.Traverse, e -> e.doit = e.detail == SWT.TRAVERSE_ESCAPE || e.doit);
  }

  Shell shell() {
    return shell;
  }

  private static GridLayout layout(int columns, int margin) {
    GridLayout layout = new GridLayout(columns, false);
    layout.marginWidth = margin;
    layout.marginHeight = margin == 0 ? 0 : Theme.STEP;
    layout.horizontalSpacing = 2 * Theme.STEP;
    layout.verticalSpacing = 0;
    return layout;
  }

  /** A row of controls. */
  Composite row(int columns) {
    Composite row = new Composite(shell, SWT.NONE);
    row.setBackground(theme.color(Role.PANEL));
    row.setLayout(layout(columns, Theme.EDGE));
    row.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    return row;
  }

  /** A field in a row that takes the room that others leave. */
  Text field(Composite row, String example, Runnable entered) {
    Text text = Boxes.ownColours(new Text(row, SWT.SINGLE | SWT.BORDER));
    text.setFont(theme.font(Face.FIGURES));
    text.setMessage(example);
    text.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    text.addListener(SWT.DefaultSelection, e -> entered.run());
    return text;
  }

  /** Where it says how it is doing. */
  NoticeLine notice() {
    NoticeLine said = new NoticeLine(shell, theme, Face.BODY);
    ((GridData) said.control().getLayoutData()).horizontalIndent = Theme.EDGE;
    return said;
  }

  /** Takes the room that is left. */
  void fill(Control table) {
    table.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
  }

  /** Keeps its height. */
  void keep(Control table, int height) {
    GridData at = new GridData(SWT.FILL, SWT.TOP, true, false);
    at.heightHint = height;
    table.setLayoutData(at);
  }

  /** Shows it above the bar, whose marks belong to what is listed: at the left, or at the right. */
  void open(int wantedWidth, int wantedHeight, boolean left) {
    Rectangle below = shell.getParent().getBounds();
    int width = Math.min(wantedWidth, below.width - 2 * MARGIN);
    int height = Math.min(wantedHeight, below.height - 2 * MARGIN);
    int top = Math.max(below.y, over.toDisplay(0, 0).y - height - 2 * MARGIN);
    int x = left ? below.x + MARGIN : below.x + below.width - width - MARGIN;
    shell.setBounds(x, top, width, height);
    shell.open();
  }
}
