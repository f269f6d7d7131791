package org.robotui.uic.map.internal.model;

import java.util.Locale;
import java.util.Optional;
import org.robotui.api.port.Envelope;
import org.robotui.data.navigation.NavigationStatus;

/**
 * A goal that navigation did not take, or gave up.
 *
 * @param receivedNanos when that was said, {@link System#nanoTime()}
 * @param words how it ended and why, in the words of navigation
 */
public record GoalFailure(long receivedNanos, String words) {
  static Optional<GoalFailure> of(Envelope<NavigationStatus> said) {
    NavigationStatus status = said.value();
    return switch (status.state()) {
      case ABORTED, REJECTED -> Optional.of(new GoalFailure(said.receivedNanos(), words(status)));
      case ACTIVE, SUCCEEDED, CANCELED -> Optional.empty();
    };
  }

  private static String words(NavigationStatus status) {
    String end = status.state().name().toLowerCase(Locale.ROOT);
    return status.text().isBlank() ? end + " by navigation" : end + ": " + status.text().strip();
  }
}
