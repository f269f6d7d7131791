package org.robotui.core.internal.port;

import java.util.Locale;
import java.util.Optional;
import org.robotui.api.time.Freshness;
import org.robotui.data.DataType;

/** The rule by which a value is too old. */
final class Staleness {
  private Staleness() {}

  /** Why a value is stale, or nothing where it is not. */
  static Optional<String> of(DataType type, boolean kept, double ageSeconds, double periodSeconds, Link link) {
    if (!link.isUp()) {
      return Optional.of("the link is lost (" + link.text() + ")");
    }
    return Freshness.isStale(type, kept, ageSeconds, periodSeconds) ? Optional.of(sentence(ageSeconds, periodSeconds))
        : Optional.empty();
  }

  private static String sentence(double age, double period) {
    String usual = period > 0 ? String.format(Locale.ROOT, ", usually every %.2f s", period) : "";
    return String.format(Locale.ROOT, "no new value for %.1f s%s; the link is up", age, usual);
  }
}
