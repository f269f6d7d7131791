package org.robotui.uic.plot.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.uic.plot.internal.model.BinnedTrace;
import org.robotui.uic.plot.internal.model.Readout;
import org.robotui.uic.plot.internal.model.Ticks;
import org.robotui.uic.plot.internal.model.ValueBins;

/** Paints the counted values of one trace: its name, bars over a scale, and what is below the pointer. */
record BinsPainter(Theme theme, TracePainter traces) {
  private static final int HEAD = 20;
  private static final int FOOT = 18;
  private static final int MARGIN = 10;
  private static final int TICK = 45;
  private static final int APART = 3;

  void paint(GC gc, Rectangle area, BinnedTrace binned, Optional<Point> pointer) {
    Rectangle plot = new Rectangle(area.x + MARGIN, area.y + HEAD, area.width - 2 * MARGIN,
        area.height - HEAD - FOOT);
    Optional<Integer> under = pointer.filter(area::contains).map(at -> bin(plot, binned.bins(), at.x));
    head(gc, area, binned, under);
    gc.setForeground(theme.color(Role.LINE));
    gc.setLineWidth(1);
    gc.drawLine(plot.x, plot.y + plot.height, plot.x + plot.width, plot.y + plot.height);
    if (binned.bins().counts().isEmpty()) {
      gc.setForeground(theme.color(Role.DIM));
      gc.setFont(theme.font(Face.SMALL));
      gc.drawText("no values", plot.x, plot.y + plot.height / 2, true);
      return;
    }
    bars(gc, plot, binned, under);
    scale(gc, plot, binned.bins());
  }

  private void head(GC gc, Rectangle area, BinnedTrace binned, Optional<Integer> under) {
    ValueBins bins = binned.bins();
    String unit = binned.trace().unit();
    String words = under.filter(bin -> bin >= 0 && bin < bins.counts().size())
        .map(bin -> Readout.of(bins.edge(bin)) + " to " + Readout.of(bins.edge(bin + 1), unit) + ": "
            + bins.counts().get(bin) + " (" + Figures.fixed(100.0 * bins.counts().get(bin) / bins.samples(), 1) + " %)")
        .orElseGet(() -> bins.samples() + (bins.samples() == 1 ? " sample" : " samples"));
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    int wide = gc.textExtent(words).x;
    int right = area.x + area.width - MARGIN - wide;
    gc.setForeground(theme.color(Role.DIM));
    gc.drawText(words, Math.max(area.x + MARGIN, right), area.y + APART, true);
    gc.setFont(theme.font(Face.SMALL_STRONG));
    gc.setForeground(traces.color(binned.trace()));
    String name = binned.trace().label() + (unit.isEmpty() ? "" : " [" + unit + "]");
    int room = right - area.x - 2 * MARGIN;
    if (room > 2 * MARGIN) {
      gc.drawText(TextFit.shorten(gc, name, room), area.x + MARGIN, area.y + APART, true);
    }
  }

  private void bars(GC gc, Rectangle plot, BinnedTrace binned, Optional<Integer> under) {
    ValueBins bins = binned.bins();
    Color color = traces.color(binned.trace());
    gc.setAntialias(SWT.OFF);
    int count = bins.counts().size();
    int gap = plot.width >= 5 * count ? 1 : 0;
    for (int bin = 0; bin < count; bin++) {
      long size = bins.counts().get(bin);
      if (size > 0) {
        int left = plot.x + plot.width * bin / count;
        int right = plot.x + plot.width * (bin + 1) / count;
        int tall = Math.max(1, (int) Math.round((double) size / bins.most() * plot.height));
        gc.setAlpha(under.filter(Integer.valueOf(bin)::equals).isPresent() ? 255 : 190);
        gc.setBackground(color);
        gc.fillRectangle(left, plot.y + plot.height - tall, Math.max(1, right - left - gap), tall);
      }
    }
    gc.setAlpha(255);
    gc.setAntialias(SWT.ON);
  }

  private void scale(GC gc, Rectangle plot, ValueBins bins) {
    double low = bins.edge(0);
    double high = bins.edge(bins.counts().size());
    Ticks ticks = Ticks.of(low, high, Math.max(2, plot.width / TICK));
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    for (int i = 0; i < ticks.count(); i++) {
      int x = plot.x + (int) Math.round((ticks.at(i) - low) / (high - low) * plot.width);
      gc.setForeground(theme.color(Role.LINE));
      gc.drawLine(x, plot.y + plot.height, x, plot.y + plot.height + APART);
      Point size = gc.textExtent(ticks.label(i));
      gc.setForeground(theme.color(Role.DIM));
      gc.drawText(ticks.label(i), Math.clamp(x - size.x / 2, plot.x - MARGIN / 2,
          Math.max(plot.x, plot.x + plot.width + MARGIN / 2 - size.x)), plot.y + plot.height + APART, true);
    }
  }

  private static int bin(Rectangle plot, ValueBins bins, int x) {
    return Math.floorDiv((x - plot.x) * Math.max(1, bins.counts().size()), Math.max(1, plot.width));
  }
}
