package org.robotui.rfic.recording.internal.tool;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import org.robotui.recording.RecordingInterval;

/**
 * A time on the command line.
 *
 * @param nanos nanoseconds since 1970, or from the beginning of the recording
 * @param fromBeginning which of both
 */
record LogTime(long nanos, boolean fromBeginning) {
  private static final int DIGITS = 9;

  /** Seconds from the beginning such as {@code 12.5}, or a time such as {@code 2026-11-27T10:00:00Z}. */
  static LogTime of(String option, String word) throws UsageException {
    try {
      if (word.matches("[0-9]{1,9}(\\.[0-9]{1,9})?")) {
        return new LogTime(new BigDecimal(word).movePointRight(DIGITS).setScale(0, RoundingMode.DOWN).longValueExact(),
            true);
      }
      Instant time = Instant.parse(word);
      return new LogTime(Math.addExact(Math.multiplyExact(time.getEpochSecond(), 1_000_000_000L), time.getNano()),
          false);
    } catch (DateTimeParseException | ArithmeticException e) {
      throw new UsageException(option + " takes seconds from the beginning, such as 12.5, or a time such as"
          + " 2026-11-27T10:00:00Z, not '" + word + "'");
    }
  }

  /** A length of time, with milliseconds. */
  static String seconds(long nanos) {
    return BigDecimal.valueOf(nanos, DIGITS).setScale(3, RoundingMode.HALF_UP).toPlainString();
  }

  /** As it can be written again. */
  static Instant instant(long nanos) {
    return Instant.ofEpochSecond(Math.floorDiv(nanos, 1_000_000_000L), Math.floorMod(nanos, 1_000_000_000L));
  }

  /** Where it lies in recordings that have such a span. */
  long in(RecordingInterval span) {
    return fromBeginning ? Math.addExact(span.start(), nanos) : nanos;
  }
}
