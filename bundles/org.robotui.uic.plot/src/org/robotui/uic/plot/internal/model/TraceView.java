package org.robotui.uic.plot.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.uic.plot.internal.trace.Series;

/**
 * A trace as the display shows it.
 *
 * @param spec as configured
 * @param colour index of the theme's trace colours
 * @param label its name
 * @param sources where it comes from, for a second line or a tooltip
 * @param unit empty where none is known
 * @param series its samples; none where its signal is wrong
 * @param state what its sources give
 * @param problem why it has no values, where it has none
 * @param losses what was lost on the way, the oldest first
 * @param late values left out since they came with a time before that of the newest
 * @param recorded what is to be said of a trace that is read whole from a recording; none while it is live
 * @param over what it is shown over in place of time
 */
public record TraceView(
    TraceSpec spec,
    int colour,
    String label,
    String sources,
    String unit,
    Optional<Series> series,
    InputState state,
    Optional<String> problem,
    List<Loss> losses,
    long late,
    Optional<String> recorded,
    Optional<CurveView> over) {
  public TraceView {
    losses = List.copyOf(losses);
  }

  /** A live one. */
  public TraceView(TraceSpec spec, int colour, String label, String sources, String unit, Optional<Series> series,
      InputState state, Optional<String> problem, List<Loss> losses, long late) {
    this(spec, colour, label, sources, unit, series, state, problem, losses, late, Optional.empty(),
        Optional.empty());
  }

  TraceView withLabel(String next) {
    return new TraceView(spec, colour, next, sources, unit, series, state, problem, losses, late, recorded,
        over);
  }

  /** Whether there is a line to draw. */
  public boolean drawn() {
    return series.isPresent() && !spec.hidden();
  }

  public long lost() {
    return losses.stream().mapToLong(Loss::count).sum();
  }
}
