package org.robotui.uic.plugins.internal.view;

import java.util.Map;
import java.util.function.Supplier;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.uic.plugins.internal.model.PluginColumn;
import org.robotui.uic.plugins.internal.model.PluginColumn.Place;

/** The headings of the list. Display thread. */
final class Headings {
  private static final int HEIGHT = 24;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final Supplier<Map<PluginColumn, Place>> places;

  Headings(Composite parent, Theme theme, Supplier<Map<PluginColumn, Place>> places) {
    this.theme = theme;
    this.places = places;
    canvas = new PaintedCanvas(parent, theme, this::paint);
    canvas.setLayoutData(Boxes.line(HEIGHT));
  }

  void redraw() {
    canvas.redraw();
  }

  private void paint(GC gc, Rectangle area) {
    gc.setFont(theme.font(Face.SMALL));
    gc.setForeground(theme.color(Role.DIM));
    places.get().forEach((column, place) -> {
      int room = place.width() - 2 * ListLook.PADDING;
      String title = TextFit.shorten(gc, column.title(), room);
      Point size = gc.textExtent(title);
      int x = place.left() + ListLook.PADDING + (column.isFigure() ? room - size.x : 0);
      gc.drawText(title, x, (area.height - size.y) / 2, true);
    });
    gc.setForeground(theme.color(Role.LINE));
    gc.setLineWidth(1);
    gc.drawLine(0, area.height - 1, area.width, area.height - 1);
  }
}
