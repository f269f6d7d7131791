package org.robotui.uic.plot.internal.view;

import java.time.ZoneId;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.uic.plot.internal.model.Loss;
import org.robotui.uic.plot.internal.model.Ticks;
import org.robotui.uic.plot.internal.model.TimeTicks;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.model.ValueSpan;

/**
 * Paints what lies behind and around the lines of an axis: grid, figures, times, and where something was lost. Display
 * thread.
 */
final class AxisPainter {
  private static final int TICK_EVERY = 38;
  private static final int TIME_EVERY = 96;
  private static final int VALUE_EVERY = 64;
  private static final int FIGURE_GAP = 8;
  private static final int LEAST_LOSS = 2;
  private static final int GROUND_ALPHA = 190;
  private static final int OPAQUE = 255;

  private final Theme theme;
  private final ZoneId zone;

  AxisPainter(Theme theme, ZoneId zone) {
    this.theme = theme;
    this.zone = zone;
  }

  static Ticks ticks(ValueSpan values, int height) {
    return Ticks.of(values.low(), values.high(), Math.max(2, height / TICK_EVERY + 1));
  }

  /** A line across an axis, and what stands below it. */
  record Mark(float x, String label) {}

  /** The times of an axis, or the values across it. */
  List<Mark> marks(AxisFrame frame, boolean live) {
    int most = Math.max(1, frame.plot().width / TIME_EVERY);
    if (frame.isCurve()) {
      Ticks ticks = Ticks.of(frame.across().orElseThrow().low(), frame.across().orElseThrow().high(),
          Math.max(2, frame.plot().width / VALUE_EVERY + 1));
      return IntStream.range(0, ticks.count()).mapToObj(i -> new Mark(frame.across(ticks.at(i)), ticks.label(i)))
          .toList();
    }
    List<TimeTicks.Tick> ticks = live ? TimeTicks.relative(frame.span(), most)
        : TimeTicks.absolute(frame.span(), most, zone);
    return ticks.stream().map(tick -> new Mark(frame.x(tick.time()), tick.label())).toList();
  }

  /** How much room the figures of an axis take beside it. */
  int gutter(GC gc, AxisFrame frame) {
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    int widest = widest(gc, ticks(frame.left(), frame.plot().height));
    return FIGURE_GAP + Theme.EDGE
        + frame.right().map(r -> Math.max(widest, widest(gc, ticks(r, frame.plot().height)))).orElse(widest);
  }

  /** Paints all but the lines; of an axis without samples only its edge and the times. */
  void paint(GC gc, AxisFrame frame, boolean live, boolean filled) {
    gc.setAntialias(SWT.OFF);
    gc.setLineWidth(1);
    gc.setLineStyle(SWT.LINE_SOLID);
    List<Mark> marks = marks(frame, live);
    if (filled) {
      losses(gc, frame);
      scale(gc, frame, frame.left(), false);
      frame.right().ifPresent(right -> scale(gc, frame, right, true));
      grid(gc, frame, marks);
    }
    gc.setForeground(theme.color(Role.LINE));
    gc.drawLine(frame.plot().x, frame.plot().y + frame.plot().height, frame.plot().x + frame.plot().width,
        frame.plot().y + frame.plot().height);
    if (frame.times().height > 0) {
      figures(gc, frame, marks);
    }
  }

  private void grid(GC gc, AxisFrame frame, List<Mark> marks) {
    gc.setForeground(theme.mix(Role.LINE, Role.PANEL, 0.55));
    for (Mark mark : marks) {
      int x = Math.round(mark.x());
      gc.drawLine(x, frame.plot().y, x, frame.plot().y + frame.plot().height - 1);
    }
  }

  private void scale(GC gc, AxisFrame frame, ValueSpan values, boolean right) {
    Ticks ticks = ticks(values, frame.plot().height);
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    Rectangle plot = frame.plot();
    for (int i = 0; i < ticks.count(); i++) {
      int y = Math.round(frame.y(ticks.at(i), right));
      if (!right) {
        gc.setForeground(ticks.at(i) == 0 ? theme.mix(Role.DIM, Role.LINE, 0.35) : theme.color(Role.LINE));
        gc.drawLine(plot.x, y, plot.x + plot.width - 1, y);
      }
      String label = ticks.label(i);
      Point size = gc.textExtent(label);
      int x = right ? plot.x + plot.width + FIGURE_GAP : plot.x - FIGURE_GAP - size.x;
      int top = Math.max(plot.y - Theme.EDGE, Math.min(plot.y + plot.height + Theme.STEP - size.y / 2, y - size.y / 2));
      gc.setForeground(theme.color(Role.DIM));
      gc.drawText(label, x, top, true);
    }
  }

  /** The unit that all traces of a scale have in common. */
  static Optional<String> unit(AxisFrame frame, boolean right) {
    List<String> units = frame.traces().stream().filter(t -> t.spec().right() == right && t.drawn())
        .map(TraceView::unit).distinct().toList();
    return units.size() == 1 && !units.getFirst().isEmpty() ? Optional.of(units.getFirst()) : Optional.empty();
  }

  /** Paints the units over the lines, on a ground through which they are only guessed. */
  void units(GC gc, AxisFrame frame) {
    gc.setFont(theme.font(Face.SMALL));
    unit(frame, false).ifPresent(unit -> unit(gc, unit, frame.plot().x + Theme.STEP, frame.plot().y + 1));
    unit(frame, true).ifPresent(
        unit -> unit(gc, unit, frame.plot().x + frame.plot().width - gc.textExtent(unit).x - Theme.STEP,
            frame.plot().y + 1));
    acrossName(frame).ifPresent(
        name -> unit(gc, name, frame.plot().x + frame.plot().width - gc.textExtent(name).x - Theme.STEP,
            frame.plot().y + frame.plot().height - gc.textExtent(name).y - 1));
  }

  private void unit(GC gc, String unit, int x, int y) {
    Point size = gc.textExtent(unit);
    gc.setAlpha(GROUND_ALPHA);
    gc.setBackground(theme.color(Role.PANEL));
    gc.fillRectangle(x - 2, y, size.x + 4, size.y);
    gc.setAlpha(OPAQUE);
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(unit, x, y, true);
  }

  /** What lies along the horizontal scale of a curve, with its unit. */
  static Optional<String> acrossName(AxisFrame frame) {
    return frame.traces().stream().flatMap(t -> t.over().stream()).findFirst()
        .map(over -> over.unit().isEmpty() ? over.label() : over.label() + " [" + over.unit() + "]");
  }

  private void figures(GC gc, AxisFrame frame, List<Mark> marks) {
    gc.setFont(theme.font(frame.isCurve() ? Face.SMALL_FIGURES : Face.SMALL));
    gc.setForeground(theme.color(Role.DIM));
    int free = Integer.MIN_VALUE;
    int right = frame.times().x + frame.times().width;
    for (Mark mark : marks) {
      Point size = gc.textExtent(mark.label());
      int x = Math.max(frame.times().x - size.x / 2,
          Math.min(right - size.x, Math.round(mark.x()) - size.x / 2));
      if (x >= free) {
        gc.drawText(mark.label(), x, frame.times().y + Theme.STEP, true);
        free = x + size.x + FIGURE_GAP;
      }
    }
  }

  private void losses(GC gc, AxisFrame frame) {
    gc.setBackground(theme.mix(Role.WARNING, Role.PANEL, 0.16));
    for (TraceView trace : frame.traces()) {
      for (Loss loss : trace.losses()) {
        if (trace.drawn() && !frame.isCurve() && loss.to() >= frame.span().from() && loss.from() <= frame.span().to()) {
          int from = Math.max(frame.plot().x, Math.round(frame.x(loss.from())));
          int to = Math.min(frame.plot().x + frame.plot().width, Math.round(frame.x(loss.to())));
          gc.fillRectangle(from, frame.plot().y, Math.max(LEAST_LOSS, to - from), frame.plot().height);
        }
      }
    }
  }

  private static int widest(GC gc, Ticks ticks) {
    int widest = 0;
    for (int i = 0; i < ticks.count(); i++) {
      widest = Math.max(widest, gc.textExtent(ticks.label(i)).x);
    }
    return widest;
  }
}
