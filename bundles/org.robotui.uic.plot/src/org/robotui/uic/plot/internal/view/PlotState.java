package org.robotui.uic.plot.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Supplier;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.api.time.PointedTime;
import org.robotui.uic.plot.internal.model.AutoRange;
import org.robotui.uic.plot.internal.model.AxisSpec;
import org.robotui.uic.plot.internal.model.CursorPair;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.TimeView;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.model.ValueSpan;
import org.robotui.uic.plot.internal.model.YRange;
import org.robotui.uic.plot.internal.trace.Summary;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/** Where the user looks, as long as the view is there: times, zoomed scales, cursors, the pointer. Display thread. */
public final class PlotState {
  private static final double WHOLE = 0.95;
  private static final double PARTS = 10;
  private static final int ACROSS = 2;
  private static final int SIDES = 3;

  private final List<TimeView> times = new ArrayList<>(List.of(TimeView.LIVE));
  private final List<Scale> scales = new ArrayList<>();
  private final PointedTime pointed;
  private Optional<CursorPair> cursors = Optional.empty();
  private Optional<Point> pointer = Optional.empty();
  private Optional<Rectangle> box = Optional.empty();
  private volatile boolean live = true;

  /**
   * Sees all.
   *
   * @param pointed the time at which the user points, here and elsewhere
   */
  public PlotState(PointedTime pointed) {
    this.pointed = pointed;
  }

  private static final class Scale {
    private Optional<ValueSpan> zoomed = Optional.empty();
    private Optional<ValueSpan> shown = Optional.empty();
  }

  /** What of the time an axis shows. */
  TimeView time(PlotScene scene, int axis) {
    return times.get(scene.spec().linked() ? 0 : Math.min(axis, times.size() - 1));
  }

  void time(PlotScene scene, int axis, TimeView next) {
    int index = scene.spec().linked() ? 0 : axis;
    while (times.size() <= index) {
      times.add(times.getFirst());
    }
    times.set(index, next);
    live = times.stream().allMatch(TimeView::isLive);
  }

  TimeSpan span(PlotScene scene, int axis) {
    return scene.replay()
        .map(replay -> time(scene, axis).played(replay.position(), scene.extent().orElse(replay.span())))
        .orElseGet(() -> time(scene, axis).span(scene.now(), scene.spec().window(), scene.extent()));
  }

  /** What is measured of an axis: what lies between the cursors, where these are shown, else what is seen. */
  TimeSpan measured(PlotScene scene, int axis) {
    return cursors.map(c -> new TimeSpan(Math.min(c.a(), c.b()), Math.max(c.a(), c.b())))
        .orElseGet(() -> span(scene, axis));
  }

  /** Whether time goes on. Any thread. */
  public boolean isLive() {
    return live;
  }

  /** Whether all that is seen goes along with the position of recordings. Display thread. */
  boolean isFollowing() {
    return times.stream().allMatch(TimeView::isFollowing);
  }

  /** Goes along with the position of recordings: as much time is seen as before, or the configured one beside all. */
  void follow(PlotScene scene) {
    double all = scene.extent().map(TimeSpan::seconds).orElse(0.0);
    for (int axis = 0; axis < axes(scene); axis++) {
      double seen = span(scene, axis).seconds();
      double window = scene.spec().window();
      double wanted = seen < all * WHOLE ? seen : window > 0 && window < all ? window : all / PARTS;
      time(scene, axis, TimeView.following(wanted));
    }
  }

  private static int axes(PlotScene scene) {
    return scene.spec().linked() ? 1 : Math.max(1, scene.axes().size());
  }

  /** Holds what is seen now. */
  void hold(PlotScene scene) {
    for (int axis = 0; axis < axes(scene); axis++) {
      time(scene, axis, time(scene, axis).hold(span(scene, axis)));
    }
  }

  /** Back to live, and to the ranges that are configured. */
  void live() {
    times.replaceAll(t -> TimeView.LIVE);
    live = true;
    scales.forEach(s -> s.zoomed = Optional.empty());
  }

  /** The values across an axis that are shown, where it has no times. */
  Optional<ValueSpan> across(PlotScene scene, int axis, TimeSpan span) {
    AxisSpec spec = scene.spec().axes().get(axis);
    return spec.x().map(x -> values(spec.across(), scale(axis, ACROSS), () -> seen(scene.axes().get(axis), span)));
  }

  void zoomAcross(int axis, ValueSpan values) {
    scale(axis, ACROSS).zoomed = Optional.of(values);
  }

  /** The values that a scale shows: where the user zoomed to, else the fixed ones, else those that are in sight. */
  ValueSpan values(PlotScene scene, int axis, boolean right, TimeSpan span) {
    return values(scene.spec().axes().get(axis).range(right), scale(axis, side(right)),
        () -> seen(scene.axes().get(axis), right, span));
  }

  private static ValueSpan values(YRange range, Scale scale, Supplier<Summary> seen) {
    if (scale.zoomed.isPresent()) {
      return scale.zoomed.get();
    }
    ValueSpan next = switch (range) {
      case YRange.Fixed f -> new ValueSpan(f.low(), f.high());
      case YRange.Hold h -> AutoRange.next(seen.get(), scale.shown, true);
      case YRange.Auto a -> AutoRange.next(seen.get(), scale.shown, false);
    };
    scale.shown = Optional.of(next);
    return next;
  }

  void zoom(int axis, boolean right, ValueSpan values) {
    scale(axis, side(right)).zoomed = Optional.of(values);
  }

  /** Whether the user zoomed a scale. */
  boolean isZoomed(int axis, boolean right) {
    return scale(axis, side(right)).zoomed.isPresent();
  }

  /** Shows what is configured for all scales of an axis. */
  void unzoom(int axis) {
    for (int side = 0; side < SIDES; side++) {
      scale(axis, side).zoomed = Optional.empty();
    }
  }

  /** Forgets the ranges shown so far: the axes are others now. */
  void forgetScales() {
    scales.clear();
  }

  public Optional<CursorPair> cursors() {
    return cursors;
  }

  void cursors(Optional<CursorPair> next) {
    cursors = next;
  }

  Optional<Point> pointer() {
    return pointer;
  }

  void pointer(Optional<Point> next) {
    pointer = next;
  }

  /** Says elsewhere at which time the pointer is here. */
  void tell(OptionalLong time) {
    time.ifPresentOrElse(at -> pointed.point(this, at), () -> pointed.leave(this));
  }

  /** At which time the user points elsewhere. Any thread. */
  public OptionalLong elsewhere() {
    return pointed.elsewhere(this);
  }

  /** What is being marked to be zoomed into. */
  Optional<Rectangle> box() {
    return box;
  }

  void box(Optional<Rectangle> next) {
    box = next;
  }

  private static Summary seen(List<TraceView> traces, boolean right, TimeSpan span) {
    Summary all = new Summary();
    Summary one = new Summary();
    traces.stream().filter(t -> t.drawn() && t.spec().right() == right).forEach(t -> {
      one.clear();
      t.series().orElseThrow().summarize(span, one);
      all.add(one);
    });
    return all;
  }

  private static Summary seen(List<TraceView> traces, TimeSpan span) {
    Summary all = new Summary();
    traces.stream().filter(TraceView::drawn).flatMap(t -> t.over().stream())
        .forEach(over -> over.curve().x().summarize(span, all));
    return all;
  }

  private static int side(boolean right) {
    return right ? 1 : 0;
  }

  private Scale scale(int axis, int side) {
    int index = SIDES * axis + side;
    while (scales.size() <= index) {
      scales.add(new Scale());
    }
    return scales.get(index);
  }
}
