package org.robotui.uic.gps.internal.model;

import java.util.Comparator;
import java.util.List;
import org.robotui.api.port.InputState;

/** The state of several sources as a whole: the best of them. */
final class WholeState {
  private WholeState() {}

  static InputState of(List<InputState> sources, InputState whole) {
    return sources.stream().min(Comparator.comparingInt(WholeState::rank)).orElse(whole);
  }

  private static int rank(InputState state) {
    return switch (state) {
      case InputState.Live l -> 0;
      case InputState.Stale s -> 1;
      case InputState.Waiting w -> 2;
      case InputState.Failed f -> 3;
      case InputState.Unconnected u -> 4;
    };
  }
}
