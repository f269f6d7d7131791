package org.robotui.uic.plot.internal;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.port.InputState;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.uic.plot.internal.model.AxisSpec;
import org.robotui.uic.plot.internal.model.LineStyle;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.PlotSpec;
import org.robotui.uic.plot.internal.model.TimeView;
import org.robotui.uic.plot.internal.model.TraceSpec;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.model.YRange;
import org.robotui.uic.plot.internal.trace.Series;
import org.robotui.uic.plot.internal.trace.TimeSpan;
import org.robotui.uic.plot.internal.view.PlotScreen;

/**
 * How long paints take while the user pans and zooms over a million samples a trace, with one trace and with ten on two
 * axes: {@code PlotBench [ROUNDS]} prints median and 95th percentile, then a line of JSON for each. Beside the time
 * that went by stands that of the processor, which other programs do not make longer.
 */
public final class PlotBench {
  private static final int SAMPLES = 1_000_000;
  private static final long EVERY = 1_000_000L;
  private static final int WIDTH = 1400;
  private static final int HEIGHT = 700;
  private static final int WARM_UP = 60;

  private final Display display = new Display();
  private final Theme theme = Themes.dark(display);
  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final int rounds;

  private PlotBench(int rounds) {
    this.rounds = rounds;
  }

  public static void main(String[] arguments) {
    new PlotBench(arguments.length > 0 ? Integer.parseInt(arguments[0]) : 300).run();
  }

  private void run() {
    System.out.printf(Locale.ROOT, "%-22s %8s %10s %10s %10s %10s%n", "", "", "median ms", "p95 ms", "CPU median",
        "CPU p95");
    for (int traces : new int[]{1, 10}) {
      for (boolean noisy : new boolean[]{false, true}) {
        measure(scene(traces, noisy), traces + " x 1 M " + (noisy ? "noise" : "smooth"));
      }
    }
    theme.dispose();
    display.dispose();
  }

  private void measure(PlotScene scene, String name) {
    TimeSpan all = scene.extent().orElseThrow();
    measure(scene, name, "pan", i -> {
      long length = all.length() / 2;
      return TimeView.LIVE.hold(new TimeSpan(0, length).moved(all.from() + length * (i % 200) / 200));
    });
    measure(scene, name, "zoom",
        i -> TimeView.LIVE.hold(all.zoomed(Math.pow(0.95, i % 200), all.from() + all.length() / 3)));
  }

  private interface Step {
    TimeView at(int index);
  }

  private void measure(PlotScene scene, String name, String what, Step step) {
    Shell shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, WIDTH, HEIGHT);
    PlotScreen screen = new PlotScreen(shell, theme, scene);
    PaintedCanvas canvas = screen.canvas();
    shell.open();
    double[] millis = new double[rounds];
    double[] cpu = new double[rounds];
    for (int i = -WARM_UP; i < rounds; i++) {
      screen.look(step.at(i + WARM_UP));
      long before = threads.getCurrentThreadCpuTime();
      double took = paint(canvas);
      if (i >= 0) {
        millis[i] = took;
        cpu[i] = (threads.getCurrentThreadCpuTime() - before) / 1e6;
      }
    }
    shell.dispose();
    print(name, what, millis, cpu);
  }

  private void print(String name, String what, double[] millis, double[] cpu) {
    Arrays.sort(millis);
    Arrays.sort(cpu);
    int p95 = Math.min(rounds - 1, rounds * 95 / 100);
    System.out.printf(Locale.ROOT, "%-22s %8s %10.2f %10.2f %10.2f %10.2f%n",
        name, what, millis[rounds / 2], millis[p95], cpu[rounds / 2], cpu[p95]);
    System.out.printf(Locale.ROOT,
        "{\"bench\":\"plot\",\"case\":\"%s\",\"what\":\"%s\",\"median_ms\":%.3f,\"p95_ms\":%.3f,"
            + "\"cpu_median_ms\":%.3f,\"cpu_p95_ms\":%.3f,\"limit_ms\":33}%n",
        name, what, millis[rounds / 2], millis[p95], cpu[rounds / 2], cpu[p95]);
  }

  /** From the request to the end of the paint, the window system's part included. */
  private double paint(PaintedCanvas canvas) {
    long before = canvas.paints();
    long start = System.nanoTime();
    canvas.redraw();
    while (canvas.paints() == before) {
      if (!display.readAndDispatch()) {
        display.sleep();
      }
    }
    display.update();
    // The request for a frame waits for the frame clock, which is no work: what counts is what was done in the paint.
    long whole = System.nanoTime() - start;
    return Math.min(whole, canvas.paintNanos() + flush()) / 1e6;
  }

  private long flush() {
    long start = System.nanoTime();
    while (display.readAndDispatch()) {
      // All that the paint left to do.
    }
    return System.nanoTime() - start;
  }

  private static PlotScene scene(int count, boolean noisy) {
    List<TraceView> views = IntStream.range(0, count).mapToObj(i -> view(i, noisy)).toList();
    List<List<TraceView>> axes = new ArrayList<>();
    int each = Math.max(1, count / 2);
    for (int from = 0; from < count; from += each) {
      axes.add(views.subList(from, Math.min(count, from + each)));
    }
    List<AxisSpec> specs = axes.stream()
        .map(a -> new AxisSpec(a.stream().map(TraceView::spec).toList(), new YRange.Auto(), new YRange.Auto()))
        .toList();
    return new PlotScene(new PlotSpec(specs, 60, true, true, LineStyle.LINE, PlotSpec.LegendPlace.AUTO), axes,
        SAMPLES * EVERY);
  }

  private static TraceView view(int index, boolean noisy) {
    Series series = new Series(SAMPLES);
    Random random = new Random(index);
    for (int i = 0; i < SAMPLES; i++) {
      double wave = Math.sin(i * (1 + index) / 60_000.0) + index * 0.3;
      series.add(i * EVERY, noisy ? wave + random.nextGaussian() * 0.3 : wave);
    }
    TraceSpec spec =
        new TraceSpec("bench.s" + index + ":value", Optional.empty(), Optional.empty(), OptionalInt.of(index % 7),
            Optional.empty(), false, false);
    return new TraceView(spec, index % 7, "s" + index, "bench", "m/s", Optional.of(series),
        new InputState.Live(1000, 0),
        Optional.empty(), List.of(), 0);
  }
}
