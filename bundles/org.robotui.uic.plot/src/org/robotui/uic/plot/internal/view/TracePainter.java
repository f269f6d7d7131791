package org.robotui.uic.plot.internal.view;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.LineAttributes;
import org.eclipse.swt.graphics.Path;
import org.robotui.ui.Palette;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.uic.plot.internal.model.LineStyle;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.trace.Sketch;

/**
 * Draws the line of a trace. Smooth lines are antialiased; one that goes up and down so much that it fills an area is
 * not, since that takes ten times as long and looks the same. Display thread.
 */
final class TracePainter {
  private static final float WEIGHT = 1.5f;
  private static final int DOT = 4;
  private static final double ALL_SMOOTH = 120_000;
  private static final double STALE_SHARE = 0.45;

  private final Theme theme;
  private final Sketch sketch = new Sketch();
  private final LineShape shape = new LineShape();

  TracePainter(Theme theme) {
    this.theme = theme;
  }

  /** The colour of a trace; what is old is paler. */
  Color color(TraceView trace) {
    Color full = theme.traces().get(trace.colour() % theme.traces().size());
    boolean live = StateView.contentAlpha(trace.state()) == 255;
    return live ? full : new Color(Palette.mix(full.getRGB(), theme.palette().rgb(Role.PANEL), STALE_SHARE));
  }

  /**
   * Draws.
   *
   * @param together how many traces share the time there is for a paint
   */
  void paint(GC gc, AxisFrame frame, TraceView trace, LineStyle style, int together) {
    trace.series().orElseThrow().sketch(frame.span(), Math.max(1, frame.plot().width), sketch);
    gc.setForeground(color(trace));
    gc.setBackground(color(trace));
    gc.setLineStyle(SWT.LINE_SOLID);
    if (style == LineStyle.DOTS) {
      dots(gc, frame, trace.spec().right());
      return;
    }
    gc.setAntialias(SWT.ON);
    double smooth = ALL_SMOOTH / Math.max(1, together);
    int at = 0;
    while (at < sketch.size()) {
      at = run(gc, frame, trace.spec().right(), style, at, smooth);
    }
  }

  /** Draws up to the next break; gives where to go on. */
  private int run(GC gc, AxisFrame frame, boolean right, LineStyle style, int from, double smooth) {
    shape.clear();
    int at = from;
    float before = 0;
    while (at < sketch.size() && Double.isFinite(sketch.value(at))) {
      float x = frame.x(sketch.time(at));
      float y = frame.y(sketch.value(at), right);
      if (at > from && style == LineStyle.STEP) {
        shape.add(x, before);
      }
      shape.add(x, y);
      before = y;
      at++;
    }
    shape.end();
    if (at == from + 1) {
      dot(gc, shape.x(0), shape.y(0));
    } else if (at > from) {
      line(gc, shape.climb() <= smooth);
    }
    return at + 1;
  }

  private void line(GC gc, boolean smooth) {
    if (smooth) {
      smooth(gc);
    } else if (sketch.isDense()) {
      columns(gc);
    } else {
      angular(gc);
    }
  }

  private void smooth(GC gc) {
    Path path = new Path(gc.getDevice());
    path.moveTo(shape.x(0), shape.y(0));
    for (int i = 1; i < shape.size(); i++) {
      path.lineTo(shape.x(i), shape.y(i));
    }
    gc.setLineAttributes(new LineAttributes(WEIGHT, SWT.CAP_ROUND, SWT.JOIN_BEVEL));
    gc.drawPath(path);
    path.dispose();
  }

  private void angular(GC gc) {
    int[] points = new int[2 * shape.size()];
    for (int i = 0; i < shape.size(); i++) {
      points[2 * i] = Math.round(shape.x(i));
      points[2 * i + 1] = Math.round(shape.y(i));
    }
    gc.setAntialias(SWT.OFF);
    gc.setLineAttributes(new LineAttributes(1, SWT.CAP_FLAT, SWT.JOIN_BEVEL));
    gc.drawPolyline(points);
    gc.setAntialias(SWT.ON);
  }

  /** One bar for each column, from its lowest point to its highest and to where the line comes from. */
  private void columns(GC gc) {
    gc.setAntialias(SWT.OFF);
    gc.setLineAttributes(new LineAttributes(1, SWT.CAP_FLAT, SWT.JOIN_BEVEL));
    int i = 0;
    int last = (int) Math.floor(shape.x(0));
    float before = shape.y(0);
    while (i < shape.size()) {
      int x = (int) Math.floor(shape.x(i));
      if (x > last + 1) {
        gc.drawLine(last, Math.round(before), x, Math.round(shape.y(i)));
        before = shape.y(i);
      }
      last = x;
      float low = before;
      float high = before;
      for (; i < shape.size() && (int) Math.floor(shape.x(i)) == x; i++) {
        low = Math.min(low, shape.y(i));
        high = Math.max(high, shape.y(i));
        before = shape.y(i);
      }
      int top = Math.round(low);
      gc.fillRectangle(x, top, 1, Math.max(1, Math.round(high) - top));
    }
    gc.setAntialias(SWT.ON);
  }

  private void dots(GC gc, AxisFrame frame, boolean right) {
    gc.setAntialias(sketch.isDense() ? SWT.OFF : SWT.ON);
    for (int i = 0; i < sketch.size(); i++) {
      if (Double.isFinite(sketch.value(i))) {
        dot(gc, frame.x(sketch.time(i)), frame.y(sketch.value(i), right));
      }
    }
    gc.setAntialias(SWT.ON);
  }

  private void dot(GC gc, float x, float y) {
    if (sketch.isDense()) {
      gc.fillRectangle(Math.round(x) - 1, Math.round(y) - 1, 2, 2);
    } else {
      gc.fillOval(Math.round(x) - DOT / 2, Math.round(y) - DOT / 2, DOT, DOT);
    }
  }
}
