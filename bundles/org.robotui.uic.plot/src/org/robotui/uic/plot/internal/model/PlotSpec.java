package org.robotui.uic.plot.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

/**
 * What is shown and how, as it is configured. Changing it gives a new one.
 *
 * @param axes from top to bottom
 * @param window seconds seen while live, 0 for all
 * @param byStamp whether time is that of the stamps, else that of the receipt
 * @param linked whether all axes show the same time
 * @param style how samples are joined
 * @param legend where names and figures stand
 * @param names signals that others can be made of
 */
public record PlotSpec(List<AxisSpec> axes, double window, boolean byStamp, boolean linked, LineStyle style,
    LegendPlace legend, List<NamedSignal> names) {
  /** Where names and figures stand. */
  public enum LegendPlace {
    AUTO, SIDE, TOP, OFF
  }

  public PlotSpec {
    axes = List.copyOf(axes);
    names = List.copyOf(names);
  }

  /** Without names. */
  public PlotSpec(List<AxisSpec> axes, double window, boolean byStamp, boolean linked, LineStyle style,
      LegendPlace legend) {
    this(axes, window, byStamp, linked, style, legend, List.of());
  }

  public boolean isEmpty() {
    return axes.stream().allMatch(a -> a.traces().isEmpty());
  }

  /** All signals and what they are shown over, each once. */
  public Stream<String> texts() {
    return Stream.concat(signals(), axes.stream().flatMap(a -> a.x().stream())).distinct();
  }

  /** With a signal over another one: on the first axis that has this one as its scale, else on a new one. */
  public PlotSpec plusCurve(String x, TraceSpec trace) {
    int there = axes.stream().map(AxisSpec::x).toList().indexOf(Optional.of(x));
    return there >= 0 ? withAxis(there, a -> a.plus(trace))
        : withAxes(Stream.concat(axes.stream(), Stream.of(AxisSpec.EMPTY.over(Optional.of(x)).plus(trace))).toList());
  }

  /** All signals, each once. */
  public Stream<String> signals() {
    return axes.stream().flatMap(a -> a.traces().stream()).map(TraceSpec::signal).distinct();
  }

  public Optional<TraceSpec> trace(TraceRef ref) {
    return ref.axis() < axes.size() && ref.trace() < axes.get(ref.axis()).traces().size()
        ? Optional.of(axes.get(ref.axis()).traces().get(ref.trace()))
        : Optional.empty();
  }

  /** With a trace more on an axis, which is made where there are fewer. */
  public PlotSpec plus(int axis, TraceSpec trace) {
    List<AxisSpec> more = new ArrayList<>(axes);
    if (axis >= more.size()) {
      more.add(AxisSpec.EMPTY);
    }
    int at = Math.min(axis, more.size() - 1);
    more.set(at, more.get(at).plus(trace));
    return withAxes(more);
  }

  /** With a trace changed. */
  public PlotSpec with(TraceRef ref, UnaryOperator<TraceSpec> change) {
    return trace(ref).isEmpty() ? this : withAxis(ref.axis(), a -> a.with(ref.trace(), old -> old.map(change)));
  }

  /** Without a trace; an axis that loses its last one goes too. */
  public PlotSpec without(TraceRef ref) {
    if (trace(ref).isEmpty()) {
      return this;
    }
    PlotSpec less = withAxis(ref.axis(), a -> a.with(ref.trace(), old -> Optional.empty()));
    return less.axes.get(ref.axis()).traces().isEmpty() ? less.withoutAxis(ref.axis()) : less;
  }

  /** With a trace on another axis; on a new one where there are fewer. */
  public PlotSpec moved(TraceRef ref, int axis) {
    if (trace(ref).isEmpty() || axis == ref.axis()) {
      return this;
    }
    return plus(axis, trace(ref).orElseThrow()).without(ref);
  }

  public PlotSpec withAxis(int axis, UnaryOperator<AxisSpec> change) {
    List<AxisSpec> changed = new ArrayList<>(axes);
    changed.set(axis, change.apply(axes.get(axis)));
    return withAxes(changed);
  }

  public PlotSpec withoutAxis(int axis) {
    List<AxisSpec> less = new ArrayList<>(axes);
    less.remove(axis);
    return withAxes(less);
  }

  public PlotSpec withAxes(List<AxisSpec> next) {
    return new PlotSpec(next, window, byStamp, linked, style, legend, names);
  }
}
