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
 * @param replay the recordings that are plotted; none where all is live
 */
public record PlotScene(PlotSpec spec, List<List<TraceView>> axes, long now, Optional<Replay> replay) {
  public PlotScene {
    axes = axes.stream().map(List::copyOf).toList();
  }

  /** Of live robots alone. */
  public PlotScene(PlotSpec spec, List<List<TraceView>> axes, long now) {
    this(spec, axes, now, Optional.empty());
  }

  public Stream<TraceView> traces() {
    return axes.stream().flatMap(List::stream);
  }

  /** From the first sample of all traces to the last. */
  public Optional<TimeSpan> extent() {
    return Stream.concat(replay.stream().map(Replay::span),
        traces().filter(this::counts).flatMap(t -> t.series().stream()).map(Series::extent).flatMap(Optional::stream))
        .reduce(TimeSpan::union);
  }

  /** Beside recordings, which may be of another day, live traces do not say from when to when there is something. */
  private boolean counts(TraceView trace) {
    return replay.isEmpty() || trace.recorded().isPresent();
  }
}
