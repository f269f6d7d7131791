package org.robotui.core.internal.config;

import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.port.Input;
import org.robotui.condition.Conditions;

/** Checks the conditions of bridges before any value comes. */
final class BridgeFilters {
  private static final String WHEN = "when";

  private BridgeFilters() {}

  /** What is wrong with the condition of a bridge, with what to write. */
  static Optional<String> fault(BridgeConfig bridge) {
    if (!bridge.settings().has(WHEN)) {
      return Optional.empty();
    }
    try {
      return looksAtValues(Conditions.parse(bridge.settings().text(WHEN), 0).needs(), bridge) ? Optional.empty()
          : Optional.of("has a 'when' that does not look at what it carries; name the port that it comes from, as in"
              + " 'when: " + bridge.from().port().port() + " FIELD > 0'");
    } catch (IllegalArgumentException e) {
      return Optional.of("has a 'when' that cannot be read: " + e.getMessage());
    }
  }

  private static boolean looksAtValues(Predicate<Input.Candidate> needs, BridgeConfig bridge) {
    return Stream.of("", "Diagnostics", "LogEntry")
        .anyMatch(type -> needs.test(new Input.Candidate(bridge.from().port(), type)));
  }
}
