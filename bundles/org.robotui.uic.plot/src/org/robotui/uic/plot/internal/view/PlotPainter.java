package org.robotui.uic.plot.internal.view;

import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.uic.plot.internal.model.LineStyle;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.Replay;
import org.robotui.uic.plot.internal.model.TraceView;

/** Paints the whole view, and knows afterwards where everything lies. Display thread. */
final class PlotPainter {
  private static final int GUTTER_STEP = 8;
  private static final int LEAST_GUTTER = 48;

  private final Theme theme;
  private final StateView states;
  private final AxisPainter axes;
  private final TracePainter lines;
  private final CurvePainter curves;
  private final CurveMarks marks;
  private final LegendPainter legends;
  private final PointerPainter pointers;
  private List<AxisFrame> frames = List.of();
  private List<LegendPainter.Place> places = List.of();
  private int gutter = LEAST_GUTTER;

  PlotPainter(Theme theme, ZoneId zone) {
    this.theme = theme;
    this.states = new StateView(theme);
    this.axes = new AxisPainter(theme, zone);
    this.lines = new TracePainter(theme);
    this.legends = new LegendPainter(theme, lines);
    this.pointers = new PointerPainter(theme, lines, zone);
    this.curves = new CurvePainter(lines);
    this.marks = new CurveMarks(theme, lines, pointers, zone);
  }

  /** Where the axes lay when painted last. */
  List<AxisFrame> frames() {
    return frames;
  }

  /** Where the names of the traces stood when painted last. */
  List<LegendPainter.Place> places() {
    return places;
  }

  void paint(GC gc, Rectangle area, PlotScene scene, PlotState state) {
    if (scene.axes().isEmpty()) {
      frames = List.of();
      places = List.of();
      return;
    }
    frames = frames(gc, area, scene, state);
    curves.begin(scene);
    Optional<AxisFrame> pointed = state.pointer().flatMap(this::plotAt);
    state.tell(pointed.flatMap(p -> timeAt(p, state.pointer().orElseThrow())).map(OptionalLong::of)
        .orElse(OptionalLong.empty()));
    List<LegendPainter.Place> named = new ArrayList<>();
    for (AxisFrame frame : frames) {
      axes.paint(gc, frame, isLive(frame, scene, state), hasSamples(frame));
      Rectangle clip = gc.getClipping();
      gc.setClipping(frame.plot().x, frame.plot().y - 1, frame.plot().width, frame.plot().height + 2);
      traces(gc, frame, scene);
      gc.setClipping(clip);
      if (hasSamples(frame)) {
        axes.units(gc, frame);
      }
      overlay(gc, frame, scene, state, pointed);
      Optional<Long> read = pointedTime(pointed, scene, frame, state);
      named.addAll(legends.paint(gc, frame, new LegendRow.Moment(read, scene.replay().map(Replay::position)),
          state.cursors(), state.pointer()));
    }
    places = List.copyOf(named);
    state.box().ifPresent(box -> pointers.box(gc, box));
  }

  /** What was painted last, as SVG. */
  String svg(Rectangle area, PlotScene scene, PlotState state) {
    return PlotSvg.write(area, frames, frame -> isLive(frame, scene, state), theme.palette(), axes,
        scene.spec().style());
  }

  private static boolean isLive(AxisFrame frame, PlotScene scene, PlotState state) {
    return scene.replay().isEmpty() && state.time(scene, frame.index()).isLive();
  }

  /** Says where what is dragged would go. */
  void target(GC gc, Rectangle at, String words) {
    pointers.target(gc, at, words);
  }

  Optional<AxisFrame> plotAt(Point point) {
    return frames.stream().filter(f -> f.plot().contains(point)).findFirst();
  }

  /** The time at a place within an axis; none where a curve is far from there. */
  Optional<Long> timeAt(AxisFrame frame, Point at) {
    return frame.isCurve() ? curves.nearest(frame, at).map(hit -> hit.at().time()) : Optional.of(frame.time(at.x));
  }

  /** With as much room for figures as the widest needs; it grows, and does not shrink, so that nothing jumps. */
  private List<AxisFrame> frames(GC gc, Rectangle area, PlotScene scene, PlotState state) {
    List<AxisFrame> made = Frames.of(area, scene, state, gutter);
    int wanted = made.stream().mapToInt(f -> axes.gutter(gc, f)).max().orElse(0);
    if (wanted > gutter) {
      gutter = Math.ceilDiv(wanted, GUTTER_STEP) * GUTTER_STEP;
      return Frames.of(area, scene, state, gutter);
    }
    return made;
  }

  private void traces(GC gc, AxisFrame frame, PlotScene scene) {
    int together = (int) scene.traces().filter(TraceView::drawn).count();
    for (TraceView trace : frame.traces()) {
      if (trace.drawn()) {
        LineStyle style = trace.spec().style().orElse(scene.spec().style());
        if (frame.isCurve() && trace.over().isPresent()) {
          curves.paint(gc, frame, trace, style, together);
        } else {
          lines.paint(gc, frame, trace, style, together);
        }
      }
    }
  }

  private Optional<Long> pointedTime(Optional<AxisFrame> pointed, PlotScene scene, AxisFrame frame, PlotState state) {
    return pointed.filter(p -> scene.spec().linked() || p.index() == frame.index())
        .flatMap(p -> timeAt(p, state.pointer().orElseThrow())).or(() -> elsewhere(frame, state));
  }

  /** Where the pointer is in another view: the values of that time are shown here too. */
  private static Optional<Long> elsewhere(AxisFrame frame, PlotState state) {
    OptionalLong time = state.pointer().isPresent() ? OptionalLong.empty() : state.elsewhere();
    return time.isPresent() && frame.span().contains(time.getAsLong()) ? Optional.of(time.getAsLong())
        : Optional.empty();
  }

  private void overlay(GC gc, AxisFrame frame, PlotScene scene, PlotState state, Optional<AxisFrame> pointed) {
    if (!hasSamples(frame)) {
      message(gc, frame);
      return;
    }
    boolean here = pointed.filter(p -> p.index() == frame.index()).isPresent();
    if (frame.isCurve()) {
      overCurve(gc, frame, scene, state, here, pointedTime(pointed, scene, frame, state));
    } else {
      overTime(gc, frame, scene, state, here, pointedTime(pointed, scene, frame, state));
    }
    TraceView first = frame.traces().getFirst();
    if (frame.traces().stream().allMatch(t -> t.state() instanceof InputState.Stale)) {
      states.paint(gc, frame.plot(), first.state());
    } else if (frame.traces().stream().noneMatch(t -> StateView.showsContent(t.state()))) {
      states.banner(gc, frame.plot(), StateView.health(first.state()),
          TextFit.shorten(gc, first.state().explanation(), frame.plot().width / 2));
    }
  }

  private void overTime(GC gc, AxisFrame frame, PlotScene scene, PlotState state, boolean here, Optional<Long> time) {
    scene.replay().ifPresent(replay -> pointers.position(gc, frame, replay));
    state.cursors().ifPresent(c -> pointers.cursors(gc, frame, c, frame.index() == 0 || !scene.spec().linked()));
    if (state.box().isEmpty()) {
      time.ifPresent(at -> pointers.values(gc, frame, at, here, state.pointer().map(p -> p.y).orElse(0)));
    }
  }

  private void overCurve(GC gc, AxisFrame frame, PlotScene scene, PlotState state, boolean here, Optional<Long> time) {
    marks.paint(gc, frame, scene, state.cursors());
    if (here && state.box().isEmpty()) {
      curves.nearest(frame, state.pointer().orElseThrow()).ifPresent(hit -> marks.pointed(gc, frame, hit));
    } else if (state.box().isEmpty()) {
      time.ifPresent(at -> marks.pointed(gc, frame, at));
    }
  }

  private static boolean hasSamples(AxisFrame frame) {
    return frame.traces().stream()
        .anyMatch(t -> t.series().filter(s -> s.size() > 1 || s.newest().isPresent()).isPresent());
  }

  /** Why there is nothing to see on an axis. */
  private void message(GC gc, AxisFrame frame) {
    if (frame.traces().isEmpty()) {
      states.message(gc, frame.plot(), Health.NONE, "No traces", "Drop a field here.");
      return;
    }
    TraceView first =
        frame.traces().stream().filter(t -> t.problem().isPresent()).findFirst().orElse(frame.traces().getFirst());
    if (first.problem().isPresent()) {
      states.message(gc, frame.plot(), Health.BAD, first.spec().signal(), first.problem().get());
    } else if (first.state() instanceof InputState.Live) {
      states.message(gc, frame.plot(), first.recorded().isPresent() ? Health.NONE : Health.WAITING,
          first.recorded().isPresent() ? "No values in the recording" : "No values yet", "");
    } else {
      states.paint(gc, frame.plot(), first.state());
    }
  }
}
