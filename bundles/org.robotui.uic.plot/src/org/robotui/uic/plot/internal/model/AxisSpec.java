package org.robotui.uic.plot.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;

/**
 * A part of the plot with scales of its own.
 *
 * @param traces from the first to the last painted
 * @param left which values the scale at the left shows
 * @param right which values the scale at the right shows
 * @param x the signal over which the traces are shown; none where that is time
 * @param across which of its values are shown
 */
public record AxisSpec(List<TraceSpec> traces, YRange left, YRange right, Optional<String> x, YRange across) {
  public static final AxisSpec EMPTY = new AxisSpec(List.of(), new YRange.Auto(), new YRange.Auto());

  public AxisSpec {
    traces = List.copyOf(traces);
  }

  /** Over time. */
  public AxisSpec(List<TraceSpec> traces, YRange left, YRange right) {
    this(traces, left, right, Optional.empty(), new YRange.Auto());
  }

  /** Over another signal, or over time. */
  public AxisSpec over(Optional<String> signal) {
    return new AxisSpec(traces, left, right, signal, new YRange.Auto());
  }

  public AxisSpec withAcross(YRange range) {
    return new AxisSpec(traces, left, right, x, range);
  }

  public YRange range(boolean atRight) {
    return atRight ? right : left;
  }

  public AxisSpec withRange(boolean atRight, YRange range) {
    return new AxisSpec(traces, atRight ? left : range, atRight ? range : right, x, across);
  }

  public AxisSpec with(List<TraceSpec> next) {
    return new AxisSpec(next, left, right, x, across);
  }

  /** With a trace more, in the first colour that no other has, unless it has one or is there already. */
  public AxisSpec plus(TraceSpec trace) {
    if (traces.stream().anyMatch(t -> t.signal().equals(trace.signal()))) {
      return this;
    }
    List<TraceSpec> more = new ArrayList<>(traces);
    more.add(trace.colour().isPresent() ? trace : trace.withColour(freeColour()));
    return new AxisSpec(more, left, right, x, across);
  }

  /** With a trace changed, or without it where nothing is given back. */
  public AxisSpec with(int index, UnaryOperator<Optional<TraceSpec>> change) {
    List<TraceSpec> changed = new ArrayList<>(traces);
    TraceSpec old = changed.remove(index);
    change.apply(Optional.of(old)).ifPresent(next -> changed.add(index, next));
    return new AxisSpec(changed, left, right, x, across);
  }

  /** The colour of a trace: its own, else by its place. */
  public int colour(int index) {
    return traces.get(index).colour().orElse(index % PlotOptions.COLOURS.size());
  }

  private int freeColour() {
    List<Integer> used = IntStream.range(0, traces.size()).mapToObj(this::colour).toList();
    return IntStream.range(0, PlotOptions.COLOURS.size()).filter(i -> !used.contains(i)).findFirst()
        .orElse(traces.size() % PlotOptions.COLOURS.size());
  }
}
