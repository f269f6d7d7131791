package org.robotui.uic.plot.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Theme;
import org.robotui.uic.plot.internal.model.AxisSpec;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.PlotSpec.LegendPlace;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.model.ValueSpan;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * Divides the view among its axes. Axes lie below each other, with the same left and right edge, so that times line up.
 */
final class Frames {
  static final int TIMES = 24;
  static final int CHIPS = 24;

  private static final int GAP = 12;
  private static final int TOP = 12;
  private static final int SIDE = 236;
  private static final int SIDE_FROM = 600;
  private static final int LEAST_PLOT = 24;

  private Frames() {}

  /** Where names and figures stand in a view of that width. */
  static LegendPlace legend(LegendPlace configured, int width) {
    if (configured == LegendPlace.AUTO) {
      return width >= SIDE_FROM ? LegendPlace.SIDE : LegendPlace.TOP;
    }
    return configured;
  }

  /**
   * Divides.
   *
   * @param area the view
   * @param gutter room for the figures of scales
   */
  static List<AxisFrame> of(Rectangle area, PlotScene scene, PlotState state, int gutter) {
    int count = scene.axes().size();
    LegendPlace place = legend(scene.spec().legend(), area.width);
    boolean right = scene.traces().anyMatch(t -> t.spec().right() && !t.spec().hidden());
    int side = place == LegendPlace.SIDE ? SIDE : 0;
    int left = area.x + gutter;
    int width = Math.max(LEAST_PLOT, area.width - gutter - side - (right ? gutter : Theme.EDGE));
    int chips = place == LegendPlace.TOP ? CHIPS : 0;
    int[] below = IntStream.range(0, count).map(i -> hasFigures(scene, i) ? TIMES : 0).toArray();
    int spare = area.height - (place == LegendPlace.TOP ? Theme.STEP : TOP) - (count - 1) * GAP
        - IntStream.of(below).sum() - (scene.spec().linked() ? 0 : Theme.STEP);
    int each = Math.max(LEAST_PLOT + chips, spare / Math.max(1, count));
    List<AxisFrame> frames = new ArrayList<>();
    int top = area.y + (place == LegendPlace.TOP ? Theme.STEP : TOP);
    for (int i = 0; i < count; i++) {
      Rectangle plot = new Rectangle(left, top + chips, width, each - chips);
      Rectangle legend = switch (place) {
        case SIDE -> new Rectangle(area.x + area.width - side, plot.y, side, plot.height);
        case TOP -> new Rectangle(left, top, width, chips);
        default -> new Rectangle(0, 0, 0, 0);
      };
      Rectangle figures = new Rectangle(left, plot.y + plot.height, below[i] > 0 ? width : 0, below[i]);
      frames.add(frame(scene, state, i, plot, legend, figures));
      top += each + below[i] + GAP;
    }
    return frames;
  }

  /** Whether figures stand below an axis: of a curve its own, of time where it is the last that shows the same. */
  private static boolean hasFigures(PlotScene scene, int axis) {
    List<AxisSpec> axes = scene.spec().axes();
    return !scene.spec().linked() || axes.get(axis).x().isPresent()
        || axes.subList(axis + 1, axes.size()).stream().allMatch(later -> later.x().isPresent());
  }

  private static AxisFrame frame(PlotScene scene, PlotState state, int axis, Rectangle plot, Rectangle legend,
      Rectangle times) {
    List<TraceView> traces = scene.axes().get(axis);
    TimeSpan span = state.span(scene, axis);
    boolean right = traces.stream().anyMatch(t -> t.spec().right() && t.drawn());
    ValueSpan left = state.values(scene, axis, false, span);
    Optional<ValueSpan> across = state.across(scene, axis, span);
    Optional<EqualScales> equal =
        across.filter(a -> EqualScales.wanted(traces)).map(a -> EqualScales.of(left, a, plot));
    return new AxisFrame(axis, traces, plot, legend, times, span, equal.map(EqualScales::left).orElse(left),
        right ? Optional.of(state.values(scene, axis, true, span)) : Optional.empty(),
        equal.map(EqualScales::across).or(() -> across));
  }
}
