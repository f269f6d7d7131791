package org.robotui.uic.jointcontrol.internal.view;

import java.util.function.Consumer;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.uic.jointcontrol.internal.model.Grid;
import org.robotui.uic.jointcontrol.internal.model.JointColumn;
import org.robotui.uic.jointcontrol.internal.model.Sorting;

/** The headings of the table: a click sorts inside the chains. Display thread. */
final class Headings {
  private static final int HEIGHT = 24;
  private static final int ARROW = 7;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final Supplier<Grid> grid;
  private Sorting sorting = Sorting.CHAIN;

  Headings(Composite parent, Theme theme, Supplier<Grid> grid, Consumer<Sorting> sorted) {
    this.theme = theme;
    this.grid = grid;
    canvas = new PaintedCanvas(parent, theme, this::paint);
    canvas.setLayoutData(Boxes.line(HEIGHT));
    canvas.setToolTipText("Click sorts inside the chains; the third click sorts from base to tip again");
    canvas.addListener(SWT.MouseUp, e -> grid.get().at(e.x).filter(column -> e.button == 1).ifPresent(column -> {
      sorting = sorting.clicked(column);
      sorted.accept(sorting);
      canvas.redraw();
    }));
  }

  Control control() {
    return canvas;
  }

  void redraw() {
    canvas.redraw();
  }

  private void paint(GC gc, Rectangle area) {
    gc.setFont(theme.font(Face.SMALL));
    grid.get().places()
        .forEach((column, place) -> heading(gc, column, new Rectangle(place.left() + TableLook.PADDING, 0,
            Math.max(0, place.width() - 2 * TableLook.PADDING), area.height)));
    gc.setForeground(theme.color(Role.LINE));
    gc.setLineWidth(1);
    gc.drawLine(0, area.height - 1, area.width, area.height - 1);
  }

  private void heading(GC gc, JointColumn column, Rectangle at) {
    boolean sorted = sorting.column().filter(c -> c == column).isPresent();
    int room = sorted ? at.width - ARROW - Theme.STEP : at.width;
    boolean whole = gc.textExtent(column.title()).x <= room;
    String title = TextFit.shorten(gc, whole ? column.title() : column.shortTitle(), room);
    Point size = gc.textExtent(title);
    int indent = column == JointColumn.RANGE ? TableLook.PADDING : 0;
    int x = column.isFigure() ? at.x + at.width - size.x : at.x + indent;
    gc.setForeground(theme.color(sorted ? Role.TEXT : Role.DIM));
    gc.drawText(title, x, (at.height - size.y) / 2, true);
    if (sorted) {
      arrow(gc, column.isFigure() ? x - ARROW - Theme.STEP : x + size.x + Theme.STEP, at.height / 2);
    }
  }

  private void arrow(GC gc, int x, int middle) {
    int point = sorting.descending() ? 2 : -2;
    gc.setBackground(theme.color(Role.TEXT));
    gc.fillPolygon(new int[]{x, middle - point, x + ARROW, middle - point, x + ARROW / 2, middle + point});
  }
}
