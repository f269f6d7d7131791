package org.robotui.uic.map.internal.model;

import java.util.Comparator;
import java.util.List;
import org.robotui.api.port.InputState;

/** The state of several inputs as a whole: the best of them. */
final class WholeState {
  private static final String HELP = "The map shows maps, laser scans, sonars, bumpers, odometry, poses and plans: ";

  private WholeState() {}

  static InputState of(List<InputState> states) {
    InputState best =
        states.stream().min(Comparator.comparingInt(WholeState::rank).thenComparingDouble(WholeState::age))
            .orElse(new InputState.Unconnected(""));
    return best instanceof InputState.Unconnected u ? new InputState.Unconnected(HELP + u.explanation()) : best;
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

  private static double age(InputState state) {
    return state instanceof InputState.Stale s ? s.ageSeconds() : 0;
  }
}
