package org.robotui.workbench.internal.pane;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/** A line of text on the ground of its parent, shortened where it does not fit. Display thread only. */
final class ShortenedLabel extends Canvas {
  private final Theme theme;
  private final Face face;
  private Role role;
  private String text;

  ShortenedLabel(Composite parent, Theme theme, Face face, Role role, String text) {
    super(parent, SWT.DOUBLE_BUFFERED);
    this.theme = theme;
    this.face = face;
    this.role = role;
    this.text = text;
    setBackground(parent.getBackground());
    addPaintListener(e -> paint(e.gc));
  }

  void show(Role inRole, String words) {
    show(inRole, words, words);
  }

  void show(Role inRole, String words, String hint) {
    if (role != inRole || !text.equals(words)) {
      role = inRole;
      text = words;
      setToolTipText(hint.isEmpty() ? null : hint);
      redraw();
    }
  }

  String text() {
    return text;
  }

  @Override
  public Point computeSize(int widthHint, int heightHint, boolean changed) {
    GC gc = new GC(this);
    gc.setFont(theme.font(face));
    Point size = gc.textExtent(text);
    gc.dispose();
    return new Point(widthHint == SWT.DEFAULT ? size.x : widthHint, heightHint == SWT.DEFAULT ? size.y : heightHint);
  }

  private void paint(GC gc) {
    gc.setFont(theme.font(face));
    gc.setForeground(theme.color(role));
    String fitting = TextFit.shorten(gc, text, getClientArea().width);
    gc.drawText(fitting, 0, (getClientArea().height - gc.textExtent(fitting).y) / 2, true);
  }
}
