package org.robotui.uic.plot.internal.view;

import java.time.ZoneId;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.uic.plot.internal.model.CurveView;
import org.robotui.uic.plot.internal.model.CursorPair;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.Readout;
import org.robotui.uic.plot.internal.model.Replay;
import org.robotui.uic.plot.internal.model.TimeTicks;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.trace.Curve;

/** Marks times on curves: now or the position of recordings, cursors, what is pointed at. Display thread. */
final class CurveMarks {
  private static final int DOT = 6;
  private static final int HEAD = 8;
  private static final int BADGE = 16;
  private static final long MILLI = 1_000_000L;

  private final Theme theme;
  private final TracePainter traces;
  private final PointerPainter pointers;
  private final ZoneId zone;

  CurveMarks(Theme theme, TracePainter traces, PointerPainter pointers, ZoneId zone) {
    this.theme = theme;
    this.traces = traces;
    this.pointers = pointers;
    this.zone = zone;
  }

  /** Where each curve of an axis is now, or was at the position of the recordings; and where at the cursors. */
  void paint(GC gc, AxisFrame frame, PlotScene scene, Optional<CursorPair> cursors) {
    for (TraceView trace : drawn(frame)) {
      Curve curve = trace.over().orElseThrow().curve();
      long head = scene.replay().map(Replay::position).orElse(frame.span().to());
      curve.lastUntil(head).filter(at -> frame.span().contains(at.time())).ifPresent(at -> head(gc, frame, trace, at));
      cursors.ifPresent(pair -> {
        curve.nearest(pair.a(), LegendRow.reach(frame)).ifPresent(at -> badge(gc, frame, trace, at, "A"));
        curve.nearest(pair.b(), LegendRow.reach(frame)).ifPresent(at -> badge(gc, frame, trace, at, "B"));
      });
    }
    scene.replay().ifPresent(replay -> pointers.progress(gc, frame, replay));
  }

  /** Where each curve is at a time that is pointed at elsewhere. */
  void pointed(GC gc, AxisFrame frame, long time) {
    for (TraceView trace : drawn(frame)) {
      trace.over().orElseThrow().curve().nearest(time, LegendRow.reach(frame))
          .ifPresent(at -> ring(gc, frame, trace, at));
    }
  }

  /** The point that the pointer is at, with its time and both values beside it. */
  void pointed(GC gc, AxisFrame frame, CurvePainter.Hit hit) {
    TraceView trace = hit.trace();
    CurveView over = trace.over().orElseThrow();
    Color color = traces.color(trace);
    ring(gc, frame, trace, hit.at());
    Point at = place(frame, trace, hit.at());
    pointers.pill(gc, frame.plot(), at.x, at.y, List.of(
        new PointerPainter.Line(TimeTicks.clock(hit.at().time(), MILLI, zone), theme.color(Role.DIM)),
        new PointerPainter.Line(Readout.of(hit.at().y(), trace.unit()) + "  " + PointerPainter.shortened(trace.label()),
            color),
        new PointerPainter.Line(Readout.of(hit.at().x(), over.unit()) + "  " + PointerPainter.shortened(over.label()),
            theme.color(Role.TEXT))));
  }

  private static List<TraceView> drawn(AxisFrame frame) {
    return frame.traces().stream().filter(t -> t.drawn() && t.over().isPresent()).toList();
  }

  private static Point place(AxisFrame frame, TraceView trace, Curve.At at) {
    return new Point(Math.round(frame.across(at.x())), Math.round(frame.y(at.y(), trace.spec().right())));
  }

  private void head(GC gc, AxisFrame frame, TraceView trace, Curve.At at) {
    Point place = place(frame, trace, at);
    if (frame.plot().contains(place)) {
      disc(gc, place, HEAD + 4, theme.color(Role.TEXT));
      disc(gc, place, HEAD, traces.color(trace));
    }
  }

  private void ring(GC gc, AxisFrame frame, TraceView trace, Curve.At at) {
    Point place = place(frame, trace, at);
    if (frame.plot().contains(place)) {
      disc(gc, place, DOT + 2, theme.color(Role.PANEL));
      disc(gc, place, DOT, traces.color(trace));
      gc.setForeground(theme.color(Role.TEXT));
      gc.setLineWidth(1);
      gc.drawOval(place.x - DOT, place.y - DOT, 2 * DOT, 2 * DOT);
    }
  }

  private static void disc(GC gc, Point place, int size, Color color) {
    gc.setAntialias(SWT.ON);
    gc.setBackground(color);
    gc.fillOval(place.x - size / 2, place.y - size / 2, size, size);
  }

  private void badge(GC gc, AxisFrame frame, TraceView trace, Curve.At at, String name) {
    Point place = place(frame, trace, at);
    Rectangle plot = frame.plot();
    if (plot.contains(place)) {
      disc(gc, place, DOT, theme.color(Role.ACCENT));
      int top = place.y - BADGE - DOT >= plot.y ? place.y - BADGE - DOT : place.y + DOT;
      gc.setBackground(theme.color(Role.ACCENT));
      gc.fillRoundRectangle(place.x - BADGE / 2, top, BADGE, BADGE, 2 * Theme.STEP, 2 * Theme.STEP);
      gc.setFont(theme.font(Face.SMALL_STRONG));
      gc.setForeground(theme.on(Role.ACCENT));
      Point size = gc.textExtent(name);
      gc.drawText(name, place.x - size.x / 2, top + (BADGE - size.y) / 2, true);
    }
  }
}
