package org.robotui.uic.plot.internal.model;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.uic.plot.internal.signal.Expr;

/** How the sources of signals are doing, at one moment. */
final class Sources {
  static final InputState WRONG = new InputState.Unconnected("the signal cannot be read");

  private static final int MOST_NAMED = 6;

  private final Input<Data> input;
  private final Set<SourceId> connected;
  private Optional<List<SourceId>> offered = Optional.empty();

  Sources(Input<Data> input) {
    this.input = input;
    this.connected = Set.copyOf(input.sources());
  }

  /** The state of that source of a signal that is worst off. */
  InputState state(Expr expr) {
    return expr.fields().map(f -> state(f.source())).max(Comparator.comparingInt(Sources::trouble)).orElse(WRONG);
  }

  private InputState state(SourceId source) {
    if (connected.contains(source)) {
      return input.state(source);
    }
    return offered().contains(source) ? new InputState.Waiting("asking for " + source)
        : new InputState.Unconnected(absent(source));
  }

  /** Asked for only where something is missing: there may be thousands. */
  private List<SourceId> offered() {
    if (offered.isEmpty()) {
      offered = Optional.of(input.candidates().stream().map(Input.Candidate::id).toList());
    }
    return offered.get();
  }

  private String absent(SourceId source) {
    List<SourceId> same = offered().stream().filter(o -> o.component().equals(source.component())).toList();
    if (offered().isEmpty()) {
      return "there is no source yet that has " + source;
    }
    if (same.isEmpty()) {
      return "there is no '" + source.component() + "'; there are "
          + offered().stream().map(SourceId::component).distinct().limit(MOST_NAMED).collect(Collectors.joining(", "));
    }
    return source.component() + " offers no '" + source.port() + "'; it offers "
        + same.stream().map(SourceId::port)
            .sorted(Comparator.comparing(p -> !p.contains(source.port().replaceFirst("^/", ""))))
            .limit(MOST_NAMED).collect(Collectors.joining(", "))
        + (same.size() > MOST_NAMED ? ", \u2026" : "");
  }

  private static int trouble(InputState state) {
    return switch (state) {
      case InputState.Live l -> 0;
      case InputState.Stale s -> 1;
      case InputState.Waiting w -> 2;
      case InputState.Unconnected u -> 3;
      case InputState.Failed f -> 4;
    };
  }
}
