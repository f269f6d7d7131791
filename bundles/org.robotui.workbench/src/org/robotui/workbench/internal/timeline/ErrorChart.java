package org.robotui.workbench.internal.timeline;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.LongConsumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.replay.ComparisonReport.ComparedError;
import org.robotui.api.time.PointedTime;
import org.robotui.ui.Face;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * An error over time, or over the way gone: the pointer says its time to views, and a click goes there. Display thread.
 */
final class ErrorChart {
  private static final int LEFT = 70;
  private static final int TOP = 22;
  private static final int FOOT = 22;
  private static final int ROW = 30;
  private static final int COLUMN = 110;
  private static final int MOST = 12;

  private final Theme theme;
  private final PaintedCanvas canvas;
  private final PointedTime pointed;
  private Optional<ErrorLine> line = Optional.empty();
  private OptionalInt pointer = OptionalInt.empty();

  /** Nothing yet; {@code seek} goes to a time. */
  ErrorChart(Composite parent, Theme theme, PointedTime pointed, LongConsumer seek) {
    this.theme = theme;
    this.pointed = pointed;
    canvas = new PaintedCanvas(parent, SWT.NONE, theme, Role.PANEL, this::paint);
    canvas.addListener(SWT.MouseMove, e -> point(OptionalInt.of(e.x)));
    canvas.addListener(SWT.MouseExit, e -> point(OptionalInt.empty()));
    canvas.addListener(SWT.MouseUp, e -> under().filter(at -> e.button == 1)
        .ifPresent(at -> seek.accept(line.orElseThrow().error().curve().time(at))));
    canvas.addListener(SWT.Dispose, e -> pointed.leave(this));
  }

  Control control() {
    return canvas;
  }

  /** Shows an error, or none. */
  void show(Optional<ComparedError> error, boolean overWay) {
    Optional<ErrorLine> next = error.filter(each -> each.curve().size() > 0).map(each -> new ErrorLine(each, overWay));
    if (!next.equals(line)) {
      line = next;
      canvas.requestPaint();
    }
  }

  private void point(OptionalInt x) {
    pointer = x;
    under().ifPresentOrElse(at -> pointed.point(this, line.orElseThrow().error().curve().time(at)),
        () -> pointed.leave(this));
    canvas.requestPaint();
  }

  /** Which error is below the pointer. */
  private Optional<Integer> under() {
    Rectangle plot = plot(canvas.getClientArea());
    return pointer.isEmpty() || pointer.getAsInt() < plot.x || pointer.getAsInt() > plot.x + plot.width
        ? Optional.empty()
        : line.map(each -> each.nearest(plot, pointer.getAsInt()));
  }

  private static Rectangle plot(Rectangle area) {
    return new Rectangle(area.x + LEFT, area.y + TOP, Math.max(1, area.width - LEFT - 2 * Theme.EDGE),
        Math.max(1, area.height - TOP - FOOT));
  }

  private void paint(GC gc, Rectangle area) {
    gc.setForeground(theme.color(Role.LINE));
    gc.drawLine(area.x, area.y, area.x + area.width, area.y);
    line.ifPresent(each -> paint(gc, plot(area), each));
  }

  private void paint(GC gc, Rectangle plot, ErrorLine shown) {
    gc.setFont(theme.font(Face.SMALL_STRONG));
    gc.setForeground(theme.color(Role.ACCENT));
    gc.drawText(shown.error().title(), plot.x, plot.y - TOP + Theme.STEP, true);
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    values(gc, plot, shown);
    places(gc, plot, shown);
    gc.setClipping(plot.x, plot.y - 1, plot.width + 1, plot.height + 2);
    mean(gc, plot, shown);
    gc.setAntialias(SWT.ON);
    gc.setForeground(theme.color(Role.ACCENT));
    gc.drawPolyline(shown.polyline(plot));
    gc.setAntialias(SWT.OFF);
    gc.setClipping((Rectangle) null);
    under().ifPresent(at -> under(gc, plot, shown, at));
  }

  private void values(GC gc, Rectangle plot, ErrorLine shown) {
    double step = shown.step(Math.clamp(plot.height / ROW, 1, MOST));
    for (double value = Math.ceil(shown.low() / step) * step; value <= shown.high(); value += step) {
      int y = shown.y(plot, value);
      gc.setForeground(theme.color(Role.LINE));
      gc.drawLine(plot.x, y, plot.x + plot.width, y);
      String label = ErrorLine.label(value, step);
      Point size = gc.textExtent(label);
      gc.setForeground(theme.color(Role.DIM));
      gc.drawText(label, plot.x - size.x - Theme.STEP, y - size.y / 2, true);
    }
  }

  private void places(GC gc, Rectangle plot, ErrorLine shown) {
    double step = shown.stepAlong(Math.clamp(plot.width / COLUMN, 1, MOST));
    gc.setForeground(theme.color(Role.DIM));
    for (double along = 0; along <= shown.length(); along += step) {
      String label = ErrorLine.label(along, step) + (shown.overWay() ? " m" : " s");
      Point size = gc.textExtent(label);
      int x = plot.x + (int) Math.round(along / shown.length() * plot.width);
      gc.drawText(label, Math.min(x - size.x / 2, plot.x + plot.width - size.x), plot.y + plot.height + Theme.STEP,
          true);
    }
  }

  /** The figure that the table begins with. */
  private void mean(GC gc, Rectangle plot, ErrorLine shown) {
    int y = shown.y(plot, shown.error().rmse());
    gc.setForeground(theme.color(Role.WARNING));
    gc.setLineStyle(SWT.LINE_DASH);
    gc.drawLine(plot.x, y, plot.x + plot.width, y);
    gc.setLineStyle(SWT.LINE_SOLID);
    Point size = gc.textExtent("RMSE");
    gc.drawText("RMSE", plot.x + plot.width - size.x - Theme.STEP, Math.max(plot.y, y - size.y - 1), true);
  }

  private void under(GC gc, Rectangle plot, ErrorLine shown, int at) {
    int x = shown.x(plot, at);
    int y = shown.y(plot, shown.error().curve().error(at));
    gc.setForeground(theme.color(Role.DIM));
    gc.drawLine(x, plot.y, x, plot.y + plot.height);
    gc.setBackground(theme.color(Role.ACCENT));
    gc.fillOval(x - 3, y - 3, 7, 7);
    TimePaint.hint(gc, theme, shown.words(at), x, plot.y - TOP + Theme.STEP, plot);
  }
}
