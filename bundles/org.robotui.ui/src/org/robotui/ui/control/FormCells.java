package org.robotui.ui.control;

import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Label;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/** The two columns of a form: names, and what is typed. Display thread. */
final class FormCells {
  private static final int STEP_IN = 12;

  /** What stands in a button before its words: its margin, its icon and the gap between. */
  private static final int CHEVRON = Theme.EDGE + Icons.SIZE + 2 * Theme.STEP;

  /** The height of a line. */
  static final int ROW = 26;
  private static final int NAME_INSET = 4;

  private final Composite root;
  private final Theme theme;

  FormCells(Composite root, Theme theme) {
    this.root = root;
    this.theme = theme;
    GridLayout layout = layout(2);
    layout.marginWidth = Theme.STEP;
    layout.marginHeight = 2 * Theme.STEP;
    layout.horizontalSpacing = Theme.EDGE;
    layout.verticalSpacing = 2;
    layout.marginRight = Theme.STEP;
    root.setLayout(layout);
  }

  Label name(int depth, String words) {
    Label label = label(root, words, Face.BODY, Role.TEXT);
    GridData data = new GridData(SWT.BEGINNING, SWT.BEGINNING, false, false);
    data.horizontalIndent = CHEVRON + depth * STEP_IN;
    data.verticalIndent = NAME_INSET;
    label.setLayoutData(data);
    return label;
  }

  /**
   * A name with a sign that opens and closes what is within: over the whole width, so that it takes none from what is
   * typed.
   */
  QuietButton head(int depth, String name, String path, boolean open, int columns, Runnable turn) {
    Composite line = part(root);
    line.setLayout(layout(columns));
    ((GridData) line.getLayoutData()).horizontalSpan = 2;
    QuietButton button = new QuietButton(line, theme, turn).icon(open ? Icon.OPEN : Icon.CLOSED).text(name)
        .hint((open ? "Close " : "Open ") + path);
    GridData data = new GridData(SWT.BEGINNING, SWT.CENTER, false, false);
    data.horizontalIndent = depth * STEP_IN;
    data.heightHint = ROW;
    button.setLayoutData(data);
    return button;
  }

  /** The right cell of a line. */
  Composite editor(int columns) {
    Composite line = part(root);
    line.setLayout(layout(columns));
    return line;
  }

  Composite part(Composite parent) {
    Composite part = new Composite(parent, SWT.NONE);
    part.setBackground(theme.color(Role.PANEL));
    part.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    return part;
  }

  void note(Composite line, String words) {
    note(line, words, Role.DIM);
  }

  void note(Composite line, String words, Role role) {
    PaintedCanvas canvas = new PaintedCanvas(line, theme, (gc, area) -> {
      gc.setFont(theme.font(Face.SMALL));
      gc.setForeground(theme.color(role));
      gc.drawText(TextFit.shorten(gc, words, area.width), 0, (area.height - gc.textExtent("X").y) / 2, true);
    });
    canvas.setToolTipText(words.replace("&", "&&"));
    GridData data = new GridData(SWT.FILL, SWT.CENTER, true, false);
    data.widthHint = 0;
    data.heightHint = ROW;
    canvas.setLayoutData(data);
  }

  QuietButton button(Composite line, Icon icon, String hint, Runnable action) {
    QuietButton button = new QuietButton(line, theme, action).icon(icon).hint(hint);
    GridData data = new GridData(SWT.BEGINNING, SWT.TOP, false, false);
    data.heightHint = ROW;
    button.setLayoutData(data);
    return button;
  }

  private Label label(Composite parent, String words, Face face, Role role) {
    Label label = new PlainLabel(parent, SWT.NONE, theme, face, role);
    label.setText(words.replace("&", "&&"));
    return label;
  }

  private static GridLayout layout(int columns) {
    GridLayout layout = new GridLayout(columns, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.horizontalSpacing = Theme.STEP;
    return layout;
  }
}
