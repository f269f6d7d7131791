package org.robotui.uic.plugins.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Face;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.uic.plugins.internal.model.Durations;
import org.robotui.uic.plugins.internal.model.Evidence;
import org.robotui.uic.plugins.internal.model.HistogramShape;

/** How often which durations occurred, with p50, p99 and the longest marked. Display thread. */
final class HistogramView {
  private static final int TITLE = 20;
  private static final int LABELS = 18;
  private static final int AXIS = 18;
  private static final int LEAST = 24;
  private static final double FAINT = 0.5;
  private static final int OPAQUE = 255;
  private static final int FADED = 90;

  /** A line at a duration. */
  private record Mark(String name, double nanos, Role role) {}

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final String title;
  private Optional<Evidence> evidence = Optional.empty();
  private long period;
  private boolean faded;

  HistogramView(Composite parent, Theme theme, String title) {
    this.theme = theme;
    this.title = title;
    canvas = new PaintedCanvas(parent, theme, this::paint);
    canvas.addListener(SWT.MouseMove, this::tell);
  }

  Control control() {
    return canvas;
  }

  /** Shows a histogram; a period of 0 is not drawn. */
  void show(Optional<Evidence> next, long every, boolean old) {
    if (!evidence.equals(next) || period != every || faded != old) {
      faded = old;
      evidence = next;
      period = every;
      canvas.redraw();
    }
  }

  private void paint(GC gc, Rectangle area) {
    Rectangle plot = plot(area);
    gc.setAlpha(faded ? FADED : OPAQUE);
    heading(gc, area);
    if (plot.height < LEAST || plot.width < LEAST) {
      return;
    }
    if (evidence.filter(e -> !e.isEmpty()).isEmpty()) {
      gc.setFont(theme.font(Face.SMALL));
      gc.setForeground(theme.color(Role.DIM));
      String words = "Nothing was measured yet";
      Point size = gc.textExtent(words);
      gc.drawText(words, plot.x + (plot.width - size.x) / 2, plot.y + (plot.height - size.y) / 2, true);
      return;
    }
    Evidence shown = evidence.get();
    HistogramShape shape = HistogramShape.of(shown.histogram(), period);
    axis(gc, plot, shape);
    bars(gc, plot, shape);
    marks(gc, plot, shape, shown);
  }

  private static Rectangle plot(Rectangle area) {
    return new Rectangle(area.x + Theme.EDGE, area.y + TITLE + LABELS, area.width - 2 * Theme.EDGE,
        area.height - TITLE - LABELS - AXIS);
  }

  private void heading(GC gc, Rectangle area) {
    gc.setFont(theme.font(Face.SMALL_STRONG));
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(title, area.x + Theme.EDGE, area.y + 3, true);
    int left = area.x + Theme.EDGE + gc.textExtent(title).x + Theme.EDGE;
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    gc.setForeground(theme.color(Role.DIM));
    int room = area.x + area.width - left - Theme.EDGE;
    String text = evidence.filter(e -> !e.isEmpty()).stream().flatMap(HistogramView::figures)
        .filter(words -> gc.textExtent(words).x <= room).findFirst().orElse("");
    gc.drawText(text, area.x + area.width - Theme.EDGE - gc.textExtent(text).x, area.y + 3, true);
  }

  /** The whole first, then with less and less. */
  private static Stream<String> figures(Evidence evidence) {
    String max = "max " + evidence.longest();
    String p99 = "p99 " + Durations.of(evidence.p99()) + "   " + max;
    return Stream.of("p50 " + Durations.of(evidence.p50()) + "   " + p99, p99, max);
  }

  private void axis(GC gc, Rectangle plot, HistogramShape shape) {
    gc.setFont(theme.font(Face.SMALL_FIGURES));
    gc.setLineWidth(1);
    gc.setAntialias(SWT.OFF);
    double[] decades = shape.decades();
    for (int i = 0; i < decades.length; i++) {
      int x = x(plot, shape.share(decades[i]));
      gc.setForeground(theme.color(Role.LINE));
      gc.drawLine(x, plot.y, x, plot.y + plot.height);
      String label = Durations.round(decades[i]);
      int width = gc.textExtent(label).x;
      int left = i == 0 ? x : i == decades.length - 1 ? x - width : x - width / 2;
      gc.setForeground(theme.color(Role.DIM));
      gc.drawText(label, left, plot.y + plot.height + 2, true);
    }
    gc.setForeground(theme.color(Role.LINE));
    gc.drawLine(plot.x, plot.y + plot.height, plot.x + plot.width, plot.y + plot.height);
  }

  private void bars(GC gc, Rectangle plot, HistogramShape shape) {
    gc.setAntialias(SWT.OFF);
    gc.setBackground(theme.mix(Role.ACCENT, Role.PANEL, FAINT));
    for (HistogramShape.Bar bar : shape.bars()) {
      int left = x(plot, bar.left());
      int height = (int) Math.max(2, Math.round(plot.height * bar.height()));
      gc.fillRectangle(left, plot.y + plot.height - height, Math.max(1, x(plot, bar.right()) - left - 1), height);
    }
  }

  private void marks(GC gc, Rectangle plot, HistogramShape shape, Evidence shown) {
    if (period > 0) {
      mark(gc, plot, shape, new Mark("period", period, shown.max() >= period ? Role.BAD : Role.DIM), Integer.MIN_VALUE);
    }
    int taken = Integer.MIN_VALUE;
    for (Mark mark : List.of(new Mark("p50", shown.p50(), Role.TEXT), new Mark("p99", shown.p99(), Role.TEXT),
        new Mark("max", shown.max(), Role.WARNING))) {
      taken = mark(gc, plot, shape, mark, taken);
    }
  }

  /** Draws a line, and its name where there is room for it; returns where the room for the next begins. */
  private int mark(GC gc, Rectangle plot, HistogramShape shape, Mark mark, int taken) {
    boolean isPeriod = mark.name().equals("period");
    int x = x(plot, shape.share(mark.nanos()));
    gc.setFont(theme.font(Face.SMALL));
    gc.setForeground(theme.color(mark.role()));
    gc.setLineStyle(isPeriod ? SWT.LINE_DASH : SWT.LINE_SOLID);
    gc.drawLine(x, plot.y - 3, x, plot.y + plot.height);
    gc.setLineStyle(SWT.LINE_SOLID);
    int width = gc.textExtent(mark.name()).x;
    int left = Math.clamp((long) x - width / 2, plot.x, Math.max(plot.x, plot.x + plot.width - width));
    if (isPeriod) {
      gc.drawText(mark.name(), Math.max(plot.x, x - width - Theme.STEP), plot.y, true);
    } else if (left > taken) {
      gc.drawText(mark.name(), left, plot.y - LABELS + 1, true);
      return left + width + Theme.STEP;
    }
    return taken;
  }

  private static int x(Rectangle plot, double share) {
    return plot.x + (int) Math.round(plot.width * share);
  }

  private void tell(Event event) {
    Rectangle plot = plot(canvas.getClientArea());
    double share = (double) (event.x - plot.x) / Math.max(1, plot.width);
    String hint = evidence.map(e -> HistogramShape.of(e.histogram(), period)).stream()
        .flatMap(shape -> shape.bars().stream())
        .filter(bar -> share >= bar.left() && share < bar.right()).findFirst()
        .map(
            bar -> Durations.of(bar.lower()) + " to " + Durations.of(bar.upper()) + ": " + Durations.count(bar.count()))
        .orElse("Both axes are logarithmic");
    if (!hint.equals(canvas.getToolTipText())) {
      canvas.setToolTipText(hint);
    }
  }
}
