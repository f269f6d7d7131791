package org.robotui.uic.plot.internal.view;

import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.uic.plot.internal.model.CursorPair;
import org.robotui.uic.plot.internal.model.Readout;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.trace.Sample;
import org.robotui.uic.plot.internal.trace.Series;
import org.robotui.uic.plot.internal.trace.Summary;

/**
 * What the legend says of a trace.
 *
 * @param trace the trace
 * @param value its value, with its unit
 * @param number its value alone
 * @param figures its extremes, or its values at the cursors
 * @param trouble why there are none, with a dot
 */
record LegendRow(TraceView trace, String value, String number, String figures, Optional<Trouble> trouble) {
  /** What is wrong, or notable. */
  record Trouble(Health health, String text) {}

  /**
   * Of which time the values are.
   *
   * @param pointed where the pointer is, if it is over a plot
   * @param position where the timeline of recordings is, if there are any
   */
  record Moment(Optional<Long> pointed, Optional<Long> position) {}

  /** At the pointer where it is over the plot, else at the position of a recording, else the newest. */
  static LegendRow of(AxisFrame frame, TraceView trace, Moment moment, Optional<CursorPair> cursors) {
    Optional<Sample> sample = trace.series().flatMap(s -> sample(frame, trace, s, moment));
    String value = sample.map(s -> Readout.of(s.value(), trace.unit())).orElse("");
    String number = sample.map(s -> Readout.of(s.value())).orElse("");
    return new LegendRow(trace, value, number, figures(frame, trace, cursors), trouble(trace));
  }

  private static Optional<Sample> sample(AxisFrame frame, TraceView trace, Series series, Moment moment) {
    if (moment.pointed().isPresent()) {
      return series.nearest(moment.pointed().get(), reach(frame));
    }
    return trace.recorded().isPresent() ? moment.position().flatMap(series::lastUntil) : series.newest();
  }

  /** How far from a time a sample may lie to be shown for it. */
  static long reach(AxisFrame frame) {
    return Math.max(frame.time(12.0), 1);
  }

  /** All there is to say, for a tooltip. */
  String tooltip() {
    StringBuilder text = new StringBuilder(trace.spec().signal());
    if (!trace.unit().isEmpty()) {
      text.append(" [").append(trace.unit()).append(']');
    }
    if (trace.series().isPresent()) {
      text.append('\n').append(trace.recorded().orElseGet(() -> StateView.word(trace.state()))).append(" \u00b7 ")
          .append(trace.series().get().size())
          .append(" samples kept");
    }
    trouble.ifPresent(t -> text.append('\n').append(t.text()));
    if (trace.late() > 0) {
      text.append('\n').append(trace.late()).append(" left out: their stamps lie before that of an earlier value");
    }
    return text.toString();
  }

  private static String figures(AxisFrame frame, TraceView trace, Optional<CursorPair> cursors) {
    return trace.series().map(series -> {
      if (cursors.isPresent()) {
        double a = series.nearest(cursors.get().a(), reach(frame)).map(Sample::value).orElse(Double.NaN);
        double b = series.nearest(cursors.get().b(), reach(frame)).map(Sample::value).orElse(Double.NaN);
        return "A " + Readout.of(a) + "  B " + Readout.of(b) + "  \u0394 " + Readout.of(b - a);
      }
      Summary summary = new Summary();
      series.summarize(frame.span(), summary);
      return summary.isEmpty() ? ""
          : Readout.of(summary.min()) + " \u2026 " + Readout.of(summary.max()) + "  \u00f8 "
              + Readout.of(summary.mean());
    }).orElse("");
  }

  private static Optional<Trouble> trouble(TraceView trace) {
    if (trace.problem().isPresent()) {
      return Optional.of(new Trouble(Health.BAD, trace.problem().get()));
    }
    return switch (trace.state()) {
      case InputState.Live l when trace.lost() > 0 -> Optional
          .of(new Trouble(Health.WARNING, trace.lost() + " values lost in transit"));
      case InputState.Live l -> Optional.empty();
      case InputState.Stale s -> Optional.of(new Trouble(Health.STALE, StateView.word(s)
          + (s.explanation().isBlank() ? "" : ": " + s.explanation())));
      default -> Optional.of(new Trouble(StateView.health(trace.state()), trace.state().explanation()));
    };
  }
}
