package org.robotui.uic.plot.internal.view;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.LineAttributes;
import org.eclipse.swt.graphics.Path;
import org.eclipse.swt.graphics.Point;
import org.robotui.uic.plot.internal.model.LineStyle;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.trace.Curve;
import org.robotui.uic.plot.internal.trace.CurveSketch;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * Draws traces over other signals than time, and finds their points. What was worked out for a screen is kept as long
 * as nothing of it changes. Display thread.
 */
final class CurvePainter {
  private static final float WEIGHT = 1.5f;
  private static final int DOT = 4;
  /** Long paths take time that grows with the square of their points. */
  private static final int TOGETHER = 256;
  private static final double ALL_SMOOTH = 60_000;
  private static final int NEAR = 48;

  private final TracePainter traces;
  private final Map<Curve, Drawn> drawn = new HashMap<>();

  CurvePainter(TracePainter traces) {
    this.traces = traces;
  }

  /** A point of a trace. */
  record Hit(TraceView trace, Curve.At at) {}

  private record Look(TimeSpan span, Curve.Fineness fineness, long version) {}

  private record Drawn(Look look, CurveSketch sketch) {}

  /** Forgets what is seen no more. */
  void begin(PlotScene scene) {
    Set<Curve> seen = scene.traces().filter(TraceView::drawn).flatMap(t -> t.over().stream())
        .map(over -> over.curve()).collect(Collectors.toSet());
    drawn.keySet().retainAll(seen);
  }

  private CurveSketch sketch(AxisFrame frame, TraceView trace) {
    Curve curve = trace.over().orElseThrow().curve();
    Look look = new Look(frame.span(), frame.fineness(trace.spec().right()), curve.y().version());
    Drawn before = drawn.get(curve);
    if (before != null && before.look.equals(look)) {
      return before.sketch;
    }
    CurveSketch sketch = before == null ? new CurveSketch() : before.sketch;
    curve.sketch(look.span, look.fineness, sketch);
    drawn.put(curve, new Drawn(look, sketch));
    return sketch;
  }

  /** Draws one, given how many share the time there is for a paint. */
  void paint(GC gc, AxisFrame frame, TraceView trace, LineStyle style, int together) {
    CurveSketch sketch = sketch(frame, trace);
    boolean right = trace.spec().right();
    gc.setForeground(traces.color(trace));
    gc.setBackground(traces.color(trace));
    gc.setLineStyle(SWT.LINE_SOLID);
    boolean smooth = !sketch.isDense() && length(frame, sketch, right) <= ALL_SMOOTH / Math.max(1, together);
    gc.setAntialias(smooth ? SWT.ON : SWT.OFF);
    int at = 0;
    while (at < sketch.size()) {
      int end = at;
      while (end < sketch.size() && end - at < TOGETHER && !Double.isNaN(sketch.y(end))) {
        end++;
      }
      if (style == LineStyle.DOTS || end - at == 1) {
        dots(gc, frame, sketch, right, at, end);
      } else if (end > at) {
        line(gc, frame, sketch, right, at, end, smooth);
      }
      boolean goesOn = end - at == TOGETHER && style != LineStyle.DOTS;
      at = goesOn ? end - 1 : Math.max(end, at + 1);
    }
    gc.setAntialias(SWT.ON);
  }

  private static void line(GC gc, AxisFrame frame, CurveSketch sketch, boolean right, int from, int to,
      boolean smooth) {
    Path path = new Path(gc.getDevice());
    path.moveTo(frame.across(sketch.x(from)), frame.y(sketch.y(from), right));
    for (int i = from + 1; i < to; i++) {
      path.lineTo(frame.across(sketch.x(i)), frame.y(sketch.y(i), right));
    }
    gc.setLineAttributes(new LineAttributes(smooth ? WEIGHT : 1, SWT.CAP_ROUND, SWT.JOIN_BEVEL));
    gc.drawPath(path);
    path.dispose();
  }

  private static void dots(GC gc, AxisFrame frame, CurveSketch sketch, boolean right, int from, int to) {
    int size = sketch.isDense() ? 2 : DOT;
    for (int i = from; i < to; i++) {
      gc.fillOval(Math.round(frame.across(sketch.x(i))) - size / 2,
          Math.round(frame.y(sketch.y(i), right)) - size / 2, size, size);
    }
  }

  /** How long the line is on the screen, in points. */
  private static double length(AxisFrame frame, CurveSketch sketch, boolean right) {
    double length = 0;
    for (int i = 1; i < sketch.size(); i++) {
      double far = Math.hypot(frame.across(sketch.x(i)) - frame.across(sketch.x(i - 1)),
          frame.y(sketch.y(i), right) - frame.y(sketch.y(i - 1), right));
      length += Double.isNaN(far) ? 0 : far;
    }
    return length;
  }

  /** The point nearest to a place on the screen, of all traces of an axis; none where all are far. */
  Optional<Hit> nearest(AxisFrame frame, Point place) {
    Optional<Hit> best = Optional.empty();
    double least = NEAR;
    for (TraceView trace : frame.traces()) {
      if (trace.drawn() && trace.over().isPresent()) {
        CurveSketch sketch = sketch(frame, trace);
        for (int i = 0; i < sketch.size(); i++) {
          double far = Math.hypot(frame.across(sketch.x(i)) - place.x,
              frame.y(sketch.y(i), trace.spec().right()) - place.y);
          if (far < least) {
            least = far;
            best = Optional.of(new Hit(trace, new Curve.At(sketch.time(i), sketch.x(i), sketch.y(i))));
          }
        }
      }
    }
    return best;
  }
}
