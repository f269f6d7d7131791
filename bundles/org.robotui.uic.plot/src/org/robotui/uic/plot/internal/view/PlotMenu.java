package org.robotui.uic.plot.internal.view;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.plot.internal.model.AxisSpec;
import org.robotui.uic.plot.internal.model.LineStyle;
import org.robotui.uic.plot.internal.model.PlotOptions;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.PlotSpec;
import org.robotui.uic.plot.internal.model.ValueSpan;
import org.robotui.uic.plot.internal.model.YRange;

/** What can be done with what is under the pointer. Display thread. */
final class PlotMenu {
  /** What the menu has the view do. */
  interface Commands {
    void choose(String text);

    void pause();

    void all();

    void cursors();

    void statistics();

    void copyStatistics();

    void histograms();

    void export(boolean all);

    void picture();

    void zoomBack(int axis);
  }

  private static final Map<String, Double> WINDOWS = windows();

  private final Edits edits;
  private final Commands commands;
  private final TraceMenu traces;

  PlotMenu(Edits edits, Commands commands, SubjectMenu ports) {
    this.edits = edits;
    this.commands = commands;
    this.traces = new TraceMenu(edits, commands::choose, ports);
  }

  /** Shows the menu for a point of the view. */
  void open(Control control, PlotScene scene, PlotState state, PlotPainter painter, Point at) {
    PopupMenu menu = new PopupMenu(control);
    painter.places().stream().filter(p -> p.at().contains(at)).findFirst()
        .ifPresent(p -> traces.fill(menu, scene, p.trace()));
    menu.line();
    axisAt(painter, at).ifPresent(frame -> axis(menu.under("Axis " + (frame.index() + 1)), scene, frame));
    menu.push("Add a trace\u2026", () -> commands.choose(""));
    menu.push("Add an axis", () -> edits.axes(s -> s.withAxes(Stream.concat(
        s.axes().stream(), Stream.of(AxisSpec.EMPTY)).toList())));
    menu.line();
    if (scene.replay().isPresent()) {
      menu.check("Follow the recording", state.isFollowing(), now -> commands.pause());
      menu.push("Show all of it", commands::all);
    } else {
      menu.push(state.isLive() ? "Pause" : "Back to live", commands::pause);
    }
    menu.check("Cursors", state.cursors().isPresent(), now -> commands.cursors());
    menu.push("Statistics", commands::statistics);
    menu.push("Copy statistics", commands::copyStatistics);
    menu.push("Histograms", commands::histograms);
    options(menu, scene.spec());
    menu.line();
    menu.push("Export what is seen\u2026", () -> commands.export(false));
    menu.push("Export all\u2026", () -> commands.export(true));
    menu.push("Save as a picture\u2026", !scene.axes().isEmpty(), commands::picture);
    menu.open();
  }

  private static Optional<AxisFrame> axisAt(PlotPainter painter, Point at) {
    return painter.frames().stream()
        .filter(f -> at.y >= f.plot().y && at.y < f.plot().y + f.plot().height || f.legend().contains(at)
            || f.isCurve() && f.times().contains(at))
        .findFirst();
  }

  private void axis(PopupMenu menu, PlotScene scene, AxisFrame frame) {
    int axis = frame.index();
    range(menu.under("Left scale"), axis, false, scene.spec().axes().get(axis).left(), frame.left());
    frame.across().ifPresent(shown -> across(menu.under("Horizontal scale"), axis,
        scene.spec().axes().get(axis).across(), shown));
    frame.right()
        .ifPresent(shown -> range(menu.under("Right scale"), axis, true, scene.spec().axes().get(axis).right(), shown));
    over(menu.under("Plot over"), scene, axis);
    menu.push("Zoom back", () -> commands.zoomBack(axis));
    menu.line();
    menu.push("Remove axis", () -> edits.axes(s -> s.withoutAxis(axis)));
  }

  /** Time, or one of the signals of the plot. */
  private void over(PopupMenu menu, PlotScene scene, int axis) {
    Optional<String> now = scene.spec().axes().get(axis).x();
    menu.radio("Time", now.isEmpty(), () -> over(axis, Optional.empty()));
    Stream.concat(now.stream(), scene.traces().map(t -> t.spec().signal())).distinct()
        .forEach(signal -> menu.radio(signal, now.equals(Optional.of(signal)), () -> over(axis, Optional.of(signal))));
  }

  private void over(int axis, Optional<String> signal) {
    edits.axes(s -> s.withAxis(axis, a -> a.over(signal)));
    commands.zoomBack(axis);
  }

  private void range(PopupMenu menu, int axis, boolean right, YRange now, ValueSpan shown) {
    range(menu, now, shown, next -> range(axis, a -> a.withRange(right, next)));
  }

  private void across(PopupMenu menu, int axis, YRange now, ValueSpan shown) {
    range(menu, now, shown, next -> range(axis, a -> a.withAcross(next)));
  }

  private static void range(PopupMenu menu, YRange now, ValueSpan shown, Consumer<YRange> change) {
    menu.radio("Fits what is seen", now instanceof YRange.Auto, () -> change.accept(new YRange.Auto()));
    menu.radio("Grows, never shrinks", now instanceof YRange.Hold, () -> change.accept(new YRange.Hold()));
    menu.radio("Fixed as it is now", now instanceof YRange.Fixed,
        () -> change.accept(new YRange.Fixed(shown.low(), shown.high())));
  }

  private void range(int axis, UnaryOperator<AxisSpec> change) {
    edits.axes(s -> s.withAxis(axis, change));
    commands.zoomBack(axis);
  }

  private void options(PopupMenu menu, PlotSpec spec) {
    PopupMenu windows = menu.under("Time seen");
    WINDOWS.forEach(
        (name, seconds) -> windows.radio(name, spec.window() == seconds, () -> edits.set(PlotOptions.WINDOW, seconds)));
    PopupMenu time = menu.under("Time of values");
    time.radio("of their stamps", spec.byStamp(), () -> edits.set(PlotOptions.TIME, PlotOptions.BY_STAMP));
    time.radio("of their receipt", !spec.byStamp(), () -> edits.set(PlotOptions.TIME, PlotOptions.BY_RECEIPT));
    PopupMenu lines = menu.under("Lines");
    for (LineStyle style : LineStyle.values()) {
      lines.radio(style.word(), spec.style() == style, () -> edits.set(PlotOptions.STYLE, style.word()));
    }
    PopupMenu legend = menu.under("Legend");
    for (PlotSpec.LegendPlace place : PlotSpec.LegendPlace.values()) {
      String word = place.name().toLowerCase(Locale.ROOT);
      legend.radio(word, spec.legend() == place, () -> edits.set(PlotOptions.LEGEND, word));
    }
    menu.check("Axes show the same time", spec.linked(), now -> edits.set(PlotOptions.LINKED, !spec.linked()));
  }

  private static Map<String, Double> windows() {
    Map<String, Double> windows = new LinkedHashMap<>();
    windows.put("5 s", 5.0);
    windows.put("10 s", 10.0);
    windows.put("30 s", 30.0);
    windows.put("1 min", 60.0);
    windows.put("5 min", 300.0);
    windows.put("10 min", 600.0);
    windows.put("1 h", 3600.0);
    windows.put("all", 0.0);
    return windows;
  }
}
