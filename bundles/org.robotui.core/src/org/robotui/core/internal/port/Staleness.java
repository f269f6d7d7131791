package org.robotui.core.internal.port;

import java.util.Locale;
import java.util.Optional;
import org.robotui.data.DataType;
import org.robotui.data.record.DynamicRecord;

/** The rule by which a value is too old. */
final class Staleness {
  private static final double AT_LEAST_SECONDS = 1;
  private static final double PERIODS = 3;

  private Staleness() {}

  /**
   * Why a value is stale, or nothing where it is not. One that is kept for late comers holds until the next, unless
   * they come as often as measurements do. A record of which only one came may be an event as well as a measurement: it
   * has no rhythm yet that could be missed.
   */
  static Optional<String> of(DataType type, boolean kept, double ageSeconds, double periodSeconds, Link link) {
    if (!link.isUp()) {
      return Optional.of("the link is lost (" + link.text() + ")");
    }
    double limit = Math.max(AT_LEAST_SECONDS, PERIODS * periodSeconds);
    boolean event = type.type() == DynamicRecord.class && periodSeconds == 0;
    boolean holds = event || kept && (periodSeconds == 0 || periodSeconds >= AT_LEAST_SECONDS);
    return type.expires() && !holds && ageSeconds > limit ? Optional.of(sentence(ageSeconds, periodSeconds))
        : Optional.empty();
  }

  private static String sentence(double age, double period) {
    String usual = period > 0 ? String.format(Locale.ROOT, ", usually every %.2f s", period) : "";
    return String.format(Locale.ROOT, "no new value for %.1f s%s; the link is up", age, usual);
  }
}
