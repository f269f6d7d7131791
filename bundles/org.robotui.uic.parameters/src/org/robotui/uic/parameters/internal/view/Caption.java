package org.robotui.uic.parameters.internal.view;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;

/** Words of one line in a form, cut where they do not fit. Display thread. */
final class Caption {
  private static final int HIGH = 24;
  private static final int LOW = 15;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final Face face;
  private String words = "";
  private Role role = Role.TEXT;

  Caption(Composite parent, Theme theme, Face face) {
    this.theme = theme;
    this.face = face;
    canvas = new PaintedCanvas(parent, theme, this::paint);
  }

  void width(int points) {
    GridData data = Boxes.middle();
    data.widthHint = points;
    data.heightHint = HIGH;
    canvas.setLayoutData(data);
  }

  void indent(int points, int span) {
    GridData data = new GridData(SWT.FILL, SWT.TOP, true, false);
    data.horizontalIndent = points;
    data.horizontalSpan = span;
    data.widthHint = 0;
    data.heightHint = LOW;
    canvas.setLayoutData(data);
  }

  void show(String text, Role color, String hint) {
    if (!words.equals(text) || role != color) {
      words = text;
      role = color;
      canvas.setToolTipText(hint.isBlank() ? null : hint.replace("&", "&&"));
      canvas.redraw();
    }
  }

  private void paint(GC gc, Rectangle area) {
    gc.setFont(theme.font(face));
    gc.setForeground(theme.color(role));
    String shown = TextFit.shorten(gc, words.replace('\n', ' '), area.width);
    gc.drawText(shown, 0, (area.height - gc.textExtent("X").y) / 2, true);
  }
}
