package org.robotui.uic.plot.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.robotui.ui.Face;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.SaveDialog;
import org.robotui.uic.plot.internal.model.BinnedTrace;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.model.ValueBins;
import org.robotui.uic.plot.internal.trace.Samples;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * Histograms of what is seen, or of what lies between the cursors, one for each trace. They are counted in the
 * background. Display thread.
 */
final class BinsPane {
  private static final int HEIGHT = 150;
  private static final int LEAST_WIDTH = 170;
  private static final int CALM_MILLIS = 200;

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final Executor background;
  private final BinsPainter painter;
  private final BiConsumer<String, String> save;
  private final Runnable again;
  private List<BinnedTrace> counted = List.of();
  private List<Part> parts = List.of();
  private Optional<Point> pointer = Optional.empty();
  private boolean busy;

  /** What one trace is counted of; the version tells that there are other samples. */
  private record Part(TraceView trace, TimeSpan span, long version) {
    /** Whether the bins of both are the same. */
    boolean isLike(Part other) {
      return span.equals(other.span) && version == other.version && trace.spec().equals(other.trace.spec())
          && trace.series().equals(other.trace.series()) && trace.unit().equals(other.trace.unit());
    }

    BinnedTrace count(Samples samples) {
      return new BinnedTrace(trace, ValueBins.of(samples, span));
    }
  }

  /** Given also who writes a text to a file, and what shows it once more. */
  BinsPane(Composite parent, Theme theme, Executor background, BiConsumer<String, String> save, Runnable again) {
    this.again = again;
    this.theme = theme;
    this.background = background;
    this.save = save;
    painter = new BinsPainter(theme, new TracePainter(theme));
    canvas = new PaintedCanvas(parent, theme, this::paint);
    canvas.setVisible(false);
    canvas.addListener(SWT.MouseMove, e -> point(Optional.of(new Point(e.x, e.y))));
    canvas.addListener(SWT.MouseExit, e -> point(Optional.empty()));
    canvas.addListener(SWT.MenuDetect, e -> {
      PopupMenu menu = new PopupMenu(canvas);
      menu.push("Copy histograms", !counted.isEmpty(), this::copy);
      menu.push("Export histograms\u2026", !counted.isEmpty(), this::export);
      menu.open(new Point(e.x, e.y));
    });
  }

  Control control() {
    return canvas;
  }

  boolean isOpen() {
    return canvas.getVisible();
  }

  void open(boolean shown) {
    canvas.setVisible(shown);
  }

  /** How high it is where there is so much room. */
  int height(int room) {
    return isOpen() ? Math.min(room / 2, HEIGHT) : 0;
  }

  /** Has counted what is seen now, unless that is so already; as often as one can look at it. */
  void show(PlotScene scene, PlotState state) {
    List<Part> next = isOpen() ? parts(scene, state) : parts;
    if (!busy && !alike(next, parts)) {
      parts = next;
      busy = true;
      List<Samples> samples = next.stream().map(part -> part.trace().series().orElseThrow().samples()).toList();
      Display display = canvas.getDisplay();
      background.execute(() -> {
        List<BinnedTrace> made = new ArrayList<>();
        for (int i = 0; i < samples.size(); i++) {
          made.add(next.get(i).count(samples.get(i)));
        }
        display.asyncExec(() -> take(made));
      });
    }
  }

  private static boolean alike(List<Part> some, List<Part> others) {
    return some.size() == others.size()
        && IntStream.range(0, some.size()).allMatch(i -> some.get(i).isLike(others.get(i)));
  }

  private void take(List<BinnedTrace> made) {
    counted = made;
    if (!canvas.isDisposed()) {
      canvas.requestPaint();
      canvas.getDisplay().timerExec(CALM_MILLIS, () -> {
        busy = false;
        if (!canvas.isDisposed()) {
          again.run();
        }
      });
    }
  }

  private static List<Part> parts(PlotScene scene, PlotState state) {
    List<Part> parts = new ArrayList<>();
    for (int axis = 0; axis < scene.axes().size(); axis++) {
      TimeSpan span = state.measured(scene, axis);
      scene.axes().get(axis).stream().filter(TraceView::drawn)
          .forEach(trace -> parts.add(new Part(trace, span, trace.series().orElseThrow().version())));
    }
    return parts;
  }

  /** As spreadsheets take it. */
  void copy() {
    Clipboards.copy(BinnedTrace.table(counted, "\t"));
  }

  void export() {
    SaveDialog.ask(canvas, "Export histograms", "histogram.csv", "*.csv")
        .ifPresent(file -> save.accept(BinnedTrace.table(counted, ","), file.toString()));
  }

  private void point(Optional<Point> at) {
    pointer = at;
    canvas.requestPaint();
  }

  private void paint(GC gc, Rectangle area) {
    gc.setForeground(theme.color(Role.LINE));
    gc.drawLine(area.x, area.y, area.x + area.width, area.y);
    if (counted.isEmpty()) {
      gc.setFont(theme.font(Face.SMALL));
      gc.setForeground(theme.color(Role.DIM));
      gc.drawText(busy ? "counting\u2026" : "no values to be counted", 2 * Theme.EDGE, area.height / 2, true);
      return;
    }
    int shown = Math.clamp(area.width / LEAST_WIDTH, 1, counted.size());
    for (int i = 0; i < shown; i++) {
      int left = area.width * i / shown;
      painter.paint(gc, new Rectangle(left, area.y + 1, area.width * (i + 1) / shown - left, area.height - 1),
          counted.get(i), pointer);
    }
  }
}
