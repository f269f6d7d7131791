package org.robotui.uic.plot.internal.view;

import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Palette;
import org.robotui.ui.Role;
import org.robotui.ui.SvgWriter;
import org.robotui.ui.SvgWriter.Anchor;
import org.robotui.uic.plot.internal.model.CurveView;
import org.robotui.uic.plot.internal.model.LineStyle;
import org.robotui.uic.plot.internal.model.Ticks;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.model.ValueSpan;
import org.robotui.uic.plot.internal.trace.Curve;
import org.robotui.uic.plot.internal.trace.CurveSketch;
import org.robotui.uic.plot.internal.trace.Sketch;

/** What a plot shows as SVG, for papers: axes, lines and names, in the colours of a theme. Pure. */
final class PlotSvg {
  private static final int SMALL = 10;
  private static final int BODY = 12;
  private static final int GAP = 8;
  private static final int SWATCH = 14;
  private static final int ROW = 20;
  private static final double LETTER = 0.6;
  private static final int FINER = 4;

  private final SvgWriter out;
  private final Palette palette;
  private final AxisPainter axes;
  private final LineStyle usual;

  private PlotSvg(SvgWriter out, Palette palette, AxisPainter axes, LineStyle usual) {
    this.out = out;
    this.palette = palette;
    this.axes = axes;
    this.usual = usual;
  }

  /**
   * Writes.
   *
   * @param area the whole view
   * @param frames where its axes lie
   * @param live of which axes times count from now
   * @param usual how lines are drawn that do not say it themselves
   */
  static String write(Rectangle area, List<AxisFrame> frames, Predicate<AxisFrame> live, Palette palette,
      AxisPainter axes, LineStyle usual) {
    SvgWriter out = new SvgWriter(area.x, area.y, area.width, area.height, palette.rgb(Role.PANEL));
    PlotSvg plot = new PlotSvg(out, palette, axes, usual);
    frames.forEach(frame -> plot.axis(frame, live.test(frame)));
    return out.end();
  }

  private void axis(AxisFrame frame, boolean live) {
    Rectangle plot = frame.plot();
    values(frame, frame.left(), false);
    frame.right().ifPresent(right -> values(frame, right, true));
    times(frame, live);
    out.element("<clipPath id=\"axis%d\"><rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\"/></clipPath>",
        frame.index(), plot.x, plot.y - 1, plot.width, plot.height + 2);
    out.element("<g clip-path=\"url(#axis%d)\" fill=\"none\" stroke-width=\"1.5\" stroke-linejoin=\"round\">",
        frame.index());
    frame.traces().stream().filter(TraceView::drawn).forEach(trace -> line(frame, trace));
    out.element("</g>");
    AxisPainter.unit(frame, false)
        .ifPresent(unit -> out.text(plot.x + 4, plot.y + BODY, SMALL, Anchor.START, palette.rgb(Role.DIM), unit));
    AxisPainter.unit(frame, true).ifPresent(
        unit -> out.text(plot.x + plot.width - 4, plot.y + BODY, SMALL, Anchor.END, palette.rgb(Role.DIM), unit));
    AxisPainter.acrossName(frame).ifPresent(name -> out.text(plot.x + plot.width - 4, plot.y + plot.height - 4, SMALL,
        Anchor.END, palette.rgb(Role.DIM), name));
    names(frame);
  }

  private void values(AxisFrame frame, ValueSpan values, boolean right) {
    Rectangle plot = frame.plot();
    Ticks ticks = AxisPainter.ticks(values, plot.height);
    for (int i = 0; i < ticks.count(); i++) {
      float y = frame.y(ticks.at(i), right);
      if (!right) {
        rule(plot.x, y, plot.x + plot.width, y);
      }
      out.text(right ? plot.x + plot.width + GAP : plot.x - GAP, y + SMALL / 3.0, SMALL,
          right ? Anchor.START : Anchor.END, palette.rgb(Role.DIM), ticks.label(i));
    }
  }

  private void times(AxisFrame frame, boolean live) {
    Rectangle plot = frame.plot();
    rule(plot.x, plot.y + plot.height, plot.x + plot.width, plot.y + plot.height);
    double free = Double.NEGATIVE_INFINITY;
    for (AxisPainter.Mark mark : axes.marks(frame, live)) {
      float x = mark.x();
      double half = width(mark.label(), SMALL) / 2;
      rule(x, plot.y, x, plot.y + plot.height);
      if (frame.times().height > 0 && x - half >= free) {
        out.text(x, frame.times().y + BODY + 4, SMALL, Anchor.MIDDLE, palette.rgb(Role.DIM), mark.label());
        free = x + half + GAP;
      }
    }
  }

  private void rule(double fromX, double fromY, double toX, double toY) {
    out.element("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>", fromX, fromY, toX, toY,
        SvgWriter.color(palette.rgb(Role.LINE)));
  }

  private RGB color(TraceView trace) {
    return palette.traces().get(trace.colour() % palette.traces().size());
  }

  private void line(AxisFrame frame, TraceView trace) {
    if (trace.over().isPresent()) {
      curve(frame, trace, trace.over().get());
      return;
    }
    Sketch sketch = new Sketch();
    trace.series().orElseThrow().sketch(frame.span(), FINER * Math.max(1, frame.plot().width), sketch);
    LineStyle style = trace.spec().style().orElse(usual);
    StringBuilder path = new StringBuilder();
    boolean begun = false;
    for (int i = 0; i < sketch.size(); i++) {
      boolean there = Double.isFinite(sketch.value(i));
      if (there) {
        point(path, style, begun, frame.x(sketch.time(i)), frame.y(sketch.value(i), trace.spec().right()));
      }
      begun = there;
    }
    path(path, trace, style);
  }

  private void curve(AxisFrame frame, TraceView trace, CurveView over) {
    CurveSketch sketch = new CurveSketch();
    Curve.Fineness screen = frame.fineness(trace.spec().right());
    over.curve().sketch(frame.span(), new Curve.Fineness(screen.x() / FINER, screen.y() / FINER), sketch);
    LineStyle style = trace.spec().style().orElse(usual) == LineStyle.DOTS ? LineStyle.DOTS : LineStyle.LINE;
    StringBuilder path = new StringBuilder();
    boolean begun = false;
    for (int i = 0; i < sketch.size(); i++) {
      boolean there = !Double.isNaN(sketch.y(i));
      if (there) {
        point(path, style, begun, frame.across(sketch.x(i)), frame.y(sketch.y(i), trace.spec().right()));
      }
      begun = there;
    }
    path(path, trace, style);
  }

  private void path(StringBuilder path, TraceView trace, LineStyle style) {
    boolean dots = style == LineStyle.DOTS;
    out.element("<path d=\"%s\" stroke=\"%s\"%s/>", path, SvgWriter.color(color(trace)),
        dots ? " stroke-width=\"3\" stroke-linecap=\"round\"" : "");
  }

  /** Goes on from the point before, where the line has begun; a line of no length is a dot. */
  private static void point(StringBuilder path, LineStyle style, boolean begun, float x, float y) {
    if (style == LineStyle.DOTS || !begun) {
      path.append(String.format(Locale.ROOT, "M%.2f %.2fh0", x, y));
    } else if (style == LineStyle.STEP) {
      path.append(String.format(Locale.ROOT, "H%.2fV%.2f", x, y));
    } else {
      path.append(String.format(Locale.ROOT, "L%.2f %.2f", x, y));
    }
  }

  /** Beside the plot one below the other, above it one after the other. */
  private void names(AxisFrame frame) {
    Rectangle legend = frame.legend();
    boolean side = legend.height > Frames.CHIPS;
    double x = legend.x + GAP;
    double y = legend.y + BODY;
    for (TraceView trace : frame.traces()) {
      if (trace.drawn() && legend.height > 0) {
        String name = trace.label() + (trace.spec().right() ? " \u2192" : "");
        out.element("<rect x=\"%.1f\" y=\"%.1f\" width=\"%d\" height=\"4\" rx=\"2\" fill=\"%s\"/>", x, y - 6, SWATCH,
            SvgWriter.color(color(trace)));
        out.text(x + SWATCH + GAP, y, BODY, Anchor.START, palette.rgb(Role.TEXT), name);
        y += side ? ROW : 0;
        x += side ? 0 : SWATCH + 3 * GAP + width(name, BODY);
      }
    }
  }

  /** About: who reads the file has letters of his own. */
  private static double width(String words, double size) {
    return LETTER * size * words.length();
  }
}
