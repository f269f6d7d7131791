package org.robotui.uic.plot.internal.model;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.uic.plot.internal.trace.Series;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/**
 * All that is shown, at one moment. The samples go on in their series.
 *
 * @param spec what is shown
 * @param axes the traces of each axis
 * @param now the newest time
 */
public record PlotScene(PlotSpec spec, List<List<TraceView>> axes, long now) {
  public PlotScene {
    axes = axes.stream().map(List::copyOf).toList();
  }

  public Stream<TraceView> traces() {
    return axes.stream().flatMap(List::stream);
  }

  /** From the first sample of all traces to the last. */
  public Optional<TimeSpan> extent() {
    return traces().flatMap(t -> t.series().stream()).map(Series::extent).flatMap(Optional::stream)
        .reduce(TimeSpan::union);
  }
}
