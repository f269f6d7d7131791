package org.robotui.uic.plot.internal.model;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Tells traces apart that would have the same name: the same field of several robots, for example. */
final class TraceNames {
  private TraceNames() {}

  /** The traces, with their sources in the name where others have the same. */
  static List<List<TraceView>> told(List<List<TraceView>> axes) {
    Map<String, Long> sources = axes.stream().flatMap(List::stream).collect(Collectors.groupingBy(TraceView::label,
        Collectors.mapping(TraceView::sources,
            Collectors.collectingAndThen(Collectors.toSet(), set -> (long) set.size()))));
    return axes.stream().map(axis -> axis.stream().map(t -> told(t, sources.get(t.label()) > 1)).toList()).toList();
  }

  private static TraceView told(TraceView trace, boolean several) {
    return several && trace.spec().label().isEmpty() && !trace.sources().isEmpty()
        ? trace.withLabel(trace.sources() + ":" + trace.label())
        : trace;
  }
}
