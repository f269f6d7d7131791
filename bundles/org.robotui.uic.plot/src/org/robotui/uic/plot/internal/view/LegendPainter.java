package org.robotui.uic.plot.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.uic.plot.internal.model.CursorPair;
import org.robotui.uic.plot.internal.model.TraceRef;
import org.robotui.uic.plot.internal.model.TraceView;

/** Paints the names and figures of the traces of an axis, and knows where each stands. Display thread. */
final class LegendPainter {
  /** Where the name of a trace stands. */
  record Place(Rectangle at, TraceRef trace, LegendRow row) {}

  private static final int TALL = 38;
  private static final int LOW = 21;
  private static final int SWATCH = 14;
  private static final int LEAST_NAME = 40;
  private static final int MORE = 24;
  private static final int CORNER = 8;

  private final Theme theme;
  private final TracePainter traces;

  LegendPainter(Theme theme, TracePainter traces) {
    this.theme = theme;
    this.traces = traces;
  }

  /** Paints the legend of an axis; gives where the traces stand in it. */
  List<Place> paint(GC gc, AxisFrame frame, LegendRow.Moment moment, Optional<CursorPair> cursors,
      Optional<Point> pointer) {
    if (frame.legend().height == 0) {
      return List.of();
    }
    List<LegendRow> rows = frame.traces().stream().map(t -> LegendRow.of(frame, t, moment, cursors)).toList();
    return frame.legend().height > Frames.CHIPS ? side(gc, frame, rows, pointer) : chips(gc, frame, rows, pointer);
  }

  private List<Place> side(GC gc, AxisFrame frame, List<LegendRow> rows, Optional<Point> pointer) {
    Rectangle area = frame.legend();
    int height = rows.size() * TALL <= area.height ? TALL : LOW;
    int fit = Math.min(rows.size(), Math.max(1, area.height / height));
    int shown = fit < rows.size() ? fit - 1 : fit;
    List<Place> places = new ArrayList<>();
    int left = area.x + Theme.EDGE;
    int width = area.width - 2 * Theme.EDGE;
    for (int i = 0; i < shown; i++) {
      Rectangle at =
          new Rectangle(left - 2 * Theme.STEP, area.y - Theme.STEP + i * height, width + 3 * Theme.STEP, height);
      places.add(new Place(at, new TraceRef(frame.index(), i), rows.get(i)));
      hover(gc, at, pointer);
      first(gc, rows.get(i), left, at.y, width);
      if (height == TALL) {
        second(gc, rows.get(i), left + SWATCH + 2 * Theme.STEP, at.y + 18, width - SWATCH - 2 * Theme.STEP);
      }
    }
    if (shown < rows.size()) {
      small(gc, "and " + (rows.size() - shown) + " more", left + SWATCH + 2 * Theme.STEP, area.y + shown * height,
          width);
    }
    return places;
  }

  private void hover(GC gc, Rectangle at, Optional<Point> pointer) {
    if (pointer.filter(at::contains).isPresent()) {
      gc.setAntialias(SWT.ON);
      gc.setBackground(theme.mix(Role.TEXT, Role.PANEL, 0.07));
      gc.fillRoundRectangle(at.x, at.y, at.width, at.height, CORNER, CORNER);
    }
  }

  private void first(GC gc, LegendRow row, int left, int top, int width) {
    swatch(gc, row.trace(), left, top + LOW / 2);
    gc.setFont(theme.font(Face.FIGURES));
    int room = width - SWATCH - 2 * Theme.STEP;
    String value = row.trace().spec().hidden() ? "hidden" : value(gc, row, room);
    Point size = gc.textExtent(value);
    boolean fits = size.x + LEAST_NAME < room;
    if (fits) {
      gc.setForeground(theme.color(row.trace().spec().hidden() ? Role.DIM : Role.TEXT));
      gc.drawText(value, left + width - size.x, top + (LOW - size.y) / 2, true);
    }
    name(gc, row.trace(), left + SWATCH + 2 * Theme.STEP, top, room - (fits ? size.x + 2 * Theme.STEP : 0));
  }

  /** With its unit, unless the name needs the room. */
  private String value(GC gc, LegendRow row, int room) {
    gc.setFont(theme.font(Face.BODY));
    int name = gc.textExtent(row.trace().label()).x;
    gc.setFont(theme.font(Face.FIGURES));
    boolean both = name + 2 * Theme.STEP + gc.textExtent(row.value()).x <= room;
    return both ? row.value() : row.number();
  }

  private void name(GC gc, TraceView trace, int x, int top, int room) {
    ink(gc, trace);
    String name = fitted(gc, trace.label() + (trace.spec().right() ? " \u2192" : ""), room);
    gc.drawText(name, x, top + (LOW - gc.textExtent(name).y) / 2, true);
  }

  private void second(GC gc, LegendRow row, int x, int top, int width) {
    if (row.trouble().isPresent()) {
      LegendRow.Trouble trouble = row.trouble().get();
      HealthDot.paint(gc, theme, trouble.health(), x + HealthDot.SIZE / 2, top + 8);
      int lead = HealthDot.SIZE + 2 * Theme.STEP;
      gc.setFont(theme.font(Face.SMALL));
      gc.setForeground(theme.color(trouble.health().role()));
      gc.drawText(TextFit.shorten(gc, trouble.text(), width - lead), x + lead, top, true);
    } else {
      small(gc, row.figures(), x, top, width);
    }
  }

  private void small(GC gc, String text, int x, int y, int width) {
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(TextFit.shorten(gc, text, width), x, y, true);
  }

  private List<Place> chips(GC gc, AxisFrame frame, List<LegendRow> rows, Optional<Point> pointer) {
    Rectangle area = frame.legend();
    List<Place> places = new ArrayList<>();
    int x = area.x + Theme.STEP;
    boolean brief = room(gc, rows) > area.width;
    String common = brief ? commonEnd(rows) : "";
    int each = Math.max(LEAST_NAME + SWATCH, area.width / Math.max(1, rows.size()));
    for (int i = 0; i < rows.size(); i++) {
      LegendRow row = rows.get(i);
      int left = area.x + area.width - x;
      if (left < LEAST_NAME + SWATCH + (i < rows.size() - 1 ? MORE : 0)) {
        small(gc, "+" + (rows.size() - i), x, area.y + Theme.STEP, left);
        return places;
      }
      int room = Math.min(each, left);
      int width = chip(gc, row, common, new Rectangle(x, area.y, room, area.height), pointer);
      places.add(new Place(new Rectangle(x, area.y, width, area.height), new TraceRef(frame.index(), i), row));
      x += width + Theme.STEP;
    }
    return places;
  }

  /** The width of all names in full. */
  private int room(GC gc, List<LegendRow> rows) {
    gc.setFont(theme.font(Face.BODY));
    return rows.stream().mapToInt(r -> gc.textExtent(r.trace().label()).x + SWATCH + 5 * Theme.STEP).sum();
  }

  /** The last step of the paths, where all have the same: what can be left out where there is no room. */
  private static String commonEnd(List<LegendRow> rows) {
    List<String> ends = rows.stream().map(r -> r.trace().label()).map(l -> l.substring(Math.max(0, l.lastIndexOf('.'))))
        .distinct().toList();
    return rows.size() > 1 && ends.size() == 1 && ends.getFirst().startsWith(".") ? ends.getFirst() : "";
  }

  private int chip(GC gc, LegendRow row, String common, Rectangle at, Optional<Point> pointer) {
    int text = at.x + SWATCH + 2 * Theme.STEP;
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    int value = row.value().isEmpty() ? 0 : gc.textExtent(row.value()).x + 2 * Theme.STEP;
    int dot = row.trouble().isPresent() ? HealthDot.SIZE + 2 * Theme.STEP : 0;
    int spare = at.width - SWATCH - 4 * Theme.STEP - dot;
    boolean fits = spare - value >= LEAST_NAME;
    gc.setFont(theme.font(Face.BODY));
    String whole = row.trace().label();
    String name = fitted(gc, whole.substring(0, whole.length() - common.length()), spare - (fits ? value : 0));
    int named = gc.textExtent(name).x;
    int width = SWATCH + 2 * Theme.STEP + named + dot + (fits ? value : 0) + 2 * Theme.STEP;
    hover(gc, new Rectangle(at.x - Theme.STEP, at.y, width, LOW), pointer);
    swatch(gc, row.trace(), at.x, at.y + LOW / 2);
    ink(gc, row.trace());
    gc.drawText(name, text, at.y + (LOW - gc.textExtent(name).y) / 2, true);
    row.trouble().ifPresent(t -> HealthDot.paint(gc, theme, t.health(),
        text + named + 2 * Theme.STEP + HealthDot.SIZE / 2, at.y + LOW / 2));
    if (fits && value > 0) {
      gc.setFont(theme.font(Face.SMALL_FIGURES));
      gc.setForeground(theme.color(Role.DIM));
      gc.drawText(row.value(), text + named + dot + 2 * Theme.STEP, at.y + (LOW - gc.textExtent(row.value()).y) / 2,
          true);
    }
    return width;
  }

  private void ink(GC gc, TraceView trace) {
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(trace.spec().hidden() ? Role.DIM : Role.TEXT));
  }

  private void swatch(GC gc, TraceView trace, int left, int middle) {
    gc.setAntialias(SWT.ON);
    if (trace.spec().hidden()) {
      gc.setForeground(theme.color(Role.DIM));
      gc.setLineWidth(1);
      gc.drawRoundRectangle(left, middle - 2, SWATCH - 1, 4, 4, 4);
    } else {
      gc.setBackground(traces.color(trace));
      gc.fillRoundRectangle(left, middle - 2, SWATCH, 4, 4, 4);
    }
  }

  /** Of paths the end says most, of what is computed the beginning. */
  private static String fitted(GC gc, String name, int room) {
    if (name.indexOf(' ') >= 0) {
      return TextFit.shorten(gc, name, room);
    }
    return TextFit.shortenFront(gc, name, room);
  }
}
