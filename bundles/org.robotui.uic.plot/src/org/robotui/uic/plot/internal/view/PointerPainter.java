package org.robotui.uic.plot.internal.view;

import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.uic.plot.internal.model.CursorPair;
import org.robotui.uic.plot.internal.model.Loss;
import org.robotui.uic.plot.internal.model.Readout;
import org.robotui.uic.plot.internal.model.Replay;
import org.robotui.uic.plot.internal.model.TimeTicks;
import org.robotui.uic.plot.internal.model.TraceView;

/** Paints what lies over the lines: values at the pointer, cursors, the box to be zoomed into. Display thread. */
final class PointerPainter {
  private static final int ROW = 17;
  private static final int DOT = 6;
  private static final int HANDLE = 16;
  private static final int FLAG = 5;

  private final Theme theme;
  private final StateView states;
  private final TracePainter traces;
  private final ZoneId zone;

  PointerPainter(Theme theme, TracePainter traces, ZoneId zone) {
    this.theme = theme;
    this.states = new StateView(theme);
    this.traces = traces;
    this.zone = zone;
  }

  record Line(String text, Color color) {}

  /** The values of the traces of an axis at a time; the words stand where the pointer is. */
  void values(GC gc, AxisFrame frame, long time, boolean words, int y) {
    int x = Math.round(frame.x(time));
    gc.setAntialias(SWT.OFF);
    gc.setForeground(theme.color(Role.DIM));
    gc.setLineWidth(1);
    gc.drawLine(x, frame.plot().y, x, frame.plot().y + frame.plot().height - 1);
    List<Line> lines = new ArrayList<>();
    lines.add(new Line(TimeTicks.clock(time, finest(frame), zone), theme.color(Role.DIM)));
    for (TraceView trace : frame.traces()) {
      if (trace.drawn()) {
        trace.series().orElseThrow().nearest(time, LegendRow.reach(frame)).ifPresent(sample -> {
          dot(gc, frame.x(sample.time()), frame.y(sample.value(), trace.spec().right()), traces.color(trace),
              frame.plot());
          lines.add(new Line(Readout.of(sample.value(), trace.unit()) + "  " + shortened(trace.label()),
              traces.color(trace)));
        });
      }
    }
    lost(frame, time)
        .ifPresent(loss -> lines.add(new Line(loss.count() + " values lost here", theme.color(Role.WARNING))));
    if (words) {
      pill(gc, frame.plot(), x, y, lines);
    }
  }

  /** The power of ten that a point on the screen tells apart. */
  private static long finest(AxisFrame frame) {
    return (long) Math.pow(10, Math.floor(Math.log10(Math.max(1, frame.time(1.0)))));
  }

  static String shortened(String label) {
    return label.length() <= 32 ? label : "\u2026" + label.substring(label.length() - 31);
  }

  private static Optional<Loss> lost(AxisFrame frame, long time) {
    return frame.traces().stream().filter(TraceView::drawn).flatMap(t -> t.losses().stream())
        .filter(l -> time >= l.from() && time <= l.to()).findFirst();
  }

  private void dot(GC gc, float x, float y, Color color, Rectangle plot) {
    if (plot.contains(Math.round(x), Math.round(y))) {
      gc.setAntialias(SWT.ON);
      gc.setBackground(color);
      gc.fillOval(Math.round(x) - DOT / 2, Math.round(y) - DOT / 2, DOT, DOT);
      gc.setForeground(theme.color(Role.PANEL));
      gc.drawOval(Math.round(x) - DOT / 2 - 1, Math.round(y) - DOT / 2 - 1, DOT + 1, DOT + 1);
    }
  }

  /** Words on a ground, beside a place. */
  void pill(GC gc, Rectangle plot, int x, int y, List<Line> lines) {
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    int width = lines.stream().mapToInt(l -> gc.textExtent(l.text()).x).max().orElse(0) + 4 * Theme.STEP;
    int height = lines.size() * ROW + 2 * Theme.STEP;
    int left = x + Theme.EDGE + width <= plot.x + plot.width ? x + Theme.EDGE : x - Theme.EDGE - width;
    int top = Math.clamp(y - height / 2, plot.y, Math.max(plot.y, plot.y + plot.height - height));
    states.pill(gc, new Rectangle(left, top, width, height));
    for (int i = 0; i < lines.size(); i++) {
      gc.setForeground(lines.get(i).color());
      gc.drawText(lines.get(i).text(), left + 2 * Theme.STEP, top + Theme.STEP + i * ROW, true);
    }
  }

  /** Where the cursors can be taken, on an axis. */
  static boolean near(AxisFrame frame, long cursor, int x) {
    return Math.abs(frame.x(cursor) - x) <= HANDLE / 3f;
  }

  void cursors(GC gc, AxisFrame frame, CursorPair cursors, boolean words) {
    int a = cursor(gc, frame, cursors.a(), "A", words);
    int b = cursor(gc, frame, cursors.b(), "B", words);
    if (words) {
      gc.setFont(theme.font(Face.SMALL_FIGURES));
      Point size = gc.textExtent(cursors.text());
      int width = size.x + 4 * Theme.STEP;
      int middle = Math.clamp((a + b) / 2 - width / 2, frame.plot().x,
          Math.max(frame.plot().x, frame.plot().x + frame.plot().width - width));
      Rectangle at = new Rectangle(middle, frame.plot().y + HANDLE + 2 * Theme.STEP, width, size.y + 2 * Theme.STEP);
      states.pill(gc, at);
      gc.setForeground(theme.color(Role.TEXT));
      gc.drawText(cursors.text(), at.x + 2 * Theme.STEP, at.y + Theme.STEP, true);
    }
  }

  private int cursor(GC gc, AxisFrame frame, long time, String name, boolean words) {
    int x = Math.round(frame.x(time));
    Rectangle plot = frame.plot();
    if (x >= plot.x && x <= plot.x + plot.width) {
      gc.setAntialias(SWT.OFF);
      gc.setForeground(theme.color(Role.ACCENT));
      gc.setLineWidth(1);
      gc.drawLine(x, plot.y, x, plot.y + plot.height - 1);
      if (words) {
        gc.setAntialias(SWT.ON);
        gc.setBackground(theme.color(Role.ACCENT));
        gc.fillRoundRectangle(x - HANDLE / 2, plot.y, HANDLE, HANDLE, 2 * Theme.STEP, 2 * Theme.STEP);
        gc.setFont(theme.font(Face.SMALL_STRONG));
        gc.setForeground(theme.on(Role.ACCENT));
        Point size = gc.textExtent(name);
        gc.drawText(name, x - size.x / 2, plot.y + (HANDLE - size.y) / 2, true);
      }
    }
    return Math.clamp(x, plot.x, plot.x + plot.width);
  }

  /** Where the timeline of recordings is, and how much of them has been read. */
  void position(GC gc, AxisFrame frame, Replay replay) {
    Rectangle plot = frame.plot();
    int x = Math.round(frame.x(replay.position()));
    gc.setAntialias(SWT.OFF);
    if (x >= plot.x && x <= plot.x + plot.width) {
      gc.setBackground(theme.color(Role.TEXT));
      gc.fillRectangle(x - 1, plot.y, 2, plot.height);
      gc.setAntialias(SWT.ON);
      gc.fillPolygon(new int[]{x - FLAG, plot.y - 1, x + FLAG, plot.y - 1, x, plot.y + FLAG});
      gc.setAntialias(SWT.OFF);
    }
    progress(gc, frame, replay);
  }

  /** How much of recordings has been read. */
  void progress(GC gc, AxisFrame frame, Replay replay) {
    Rectangle plot = frame.plot();
    replay.progress().ifPresent(progress -> {
      gc.setBackground(theme.color(Role.ACCENT));
      gc.fillRectangle(plot.x, plot.y + plot.height - 1, (int) Math.round(progress * plot.width), 2);
    });
  }

  void box(GC gc, Rectangle box) {
    gc.setAlpha(40);
    gc.setBackground(theme.color(Role.ACCENT));
    gc.fillRectangle(box);
    gc.setAlpha(255);
    gc.setAntialias(SWT.OFF);
    gc.setLineWidth(1);
    gc.setForeground(theme.color(Role.ACCENT));
    gc.drawRectangle(box);
  }

  /** Where what is dragged would go. */
  void target(GC gc, Rectangle at, String words) {
    gc.setAlpha(30);
    gc.setBackground(theme.color(Role.ACCENT));
    gc.fillRectangle(at);
    gc.setAlpha(255);
    gc.setForeground(theme.color(Role.ACCENT));
    gc.setLineWidth(1);
    gc.drawRectangle(at.x, at.y, at.width - 1, at.height - 1);
    gc.setFont(theme.font(Face.BODY));
    Point size = gc.textExtent(words);
    gc.drawText(words, at.x + (at.width - size.x) / 2, at.y + (at.height - size.y) / 2, true);
  }
}
