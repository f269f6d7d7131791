package org.robotui.uic.topics.internal.view;

import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/** The name of what is selected, and its type below where there is one. Display thread. */
final class Heading {
  static final int HEIGHT = 34;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private String name = "";
  private String type = "";

  Heading(Composite parent, Theme theme) {
    this.theme = theme;
    canvas = new PaintedCanvas(parent, theme, this::paint);
  }

  Control control() {
    return canvas;
  }

  void show(String title, String below) {
    if (!name.equals(title) || !type.equals(below)) {
      name = title;
      type = below;
      canvas.setToolTipText(below.isEmpty() ? title : title + "\n" + below);
      canvas.redraw();
    }
  }

  private void paint(GC gc, Rectangle area) {
    int room = area.width - 2 * Theme.STEP;
    gc.setFont(theme.font(Face.BODY_STRONG));
    int high = gc.textExtent("X").y;
    gc.setFont(theme.font(Face.SMALL));
    int low = type.isEmpty() ? 0 : gc.textExtent("X").y;
    int top = (area.height - high - low) / 2;
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(TextFit.shorten(gc, type, room), Theme.STEP, top + high, true);
    gc.setFont(theme.font(Face.BODY_STRONG));
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(TextFit.shorten(gc, name, room), Theme.STEP, top, true);
  }
}
