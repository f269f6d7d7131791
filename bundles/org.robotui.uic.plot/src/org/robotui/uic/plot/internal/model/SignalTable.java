package org.robotui.uic.plot.internal.model;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.uic.plot.internal.signal.Expr;

/** What the texts of a plot mean; each is read once. Worker only. */
final class SignalTable {
  private final Map<String, Signal> signals = new HashMap<>();
  private List<NamedSignal> defined = List.of();

  /** Reads those that are new, and forgets those that are gone. */
  void follow(PlotSpec spec) {
    if (!spec.names().equals(defined)) {
      defined = spec.names();
      signals.clear();
    }
    SignalNames names = new SignalNames(defined);
    Set<String> wanted = spec.texts().collect(Collectors.toSet());
    signals.keySet().retainAll(wanted);
    wanted.forEach(text -> signals.computeIfAbsent(text, t -> Signal.of(t, names)));
  }

  /** What a trace of an axis shows: a signal over time, or over that of the axis. */
  Signal of(AxisSpec axis, TraceSpec trace) {
    Signal shown = signals.get(trace.signal());
    return axis.x().map(x -> over(shown, signals.get(x))).orElse(shown);
  }

  private static Signal over(Signal shown, Signal x) {
    if (shown.error().isPresent()) {
      return shown;
    }
    return new Signal(x.expr().map(across -> new Expr.Over(shown.expr().orElseThrow(), across)),
        x.error().map(error -> "x: " + error));
  }

  /** All that is to be recorded. */
  Set<Expr> wanted(PlotSpec spec) {
    return spec.axes().stream().flatMap(axis -> axis.traces().stream().map(trace -> of(axis, trace).expr()))
        .flatMap(Optional::stream).collect(Collectors.toSet());
  }
}
