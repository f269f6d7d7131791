package org.robotui.workbench.internal.timeline;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import org.robotui.ui.Figures;

/** Times of recordings as users read and write them. */
final class TimeWords {
  static final long SECOND = 1_000_000_000L;
  static final long MINUTE = 60 * SECOND;
  static final long HOUR = 60 * MINUTE;
  static final long DAY = 24 * HOUR;

  private static final int NANO_DIGITS = 9;
  private static final Pattern SECONDS = Pattern.compile("[-+]?\\d{1,10}(\\.\\d{0,9})?");
  private static final DateTimeFormatter LOCAL = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss.SSS", Locale.ROOT);

  private TimeWords() {}

  /** By the clock of a place, with milliseconds. */
  static String local(long time, ZoneId zone) {
    return LOCAL.format(
        Instant.ofEpochSecond(Math.floorDiv(time, SECOND), Math.floorMod(time, SECOND)).atZone(zone));
  }

  /** How long after the start, in seconds, with milliseconds. */
  static String seconds(long nanos) {
    return Figures.of(nanos / (double) SECOND, 3, "s");
  }

  /**
   * A length of time with so many decimals of a second: {@code 7.5 s}, {@code 1:07.5}, {@code 2:01:07.5},
   * {@code 3 d 2:01:07}; of whole days the days alone.
   */
  static String elapsed(long nanos, int decimals) {
    long size = Math.abs(nanos);
    String sign = nanos < 0 ? "\u2212" : "";
    if (size >= DAY) {
      String rest = size % DAY == 0 && decimals == 0 ? "" : "\u00a0" + clock(size % DAY, decimals);
      return sign + size / DAY + "\u00a0d" + rest;
    }
    if (size < MINUTE) {
      return sign + fixed(size, decimals) + "\u00a0s";
    }
    return sign + (size < HOUR ? size / MINUTE + ":" + padded(size, decimals) : clock(size, decimals));
  }

  private static String clock(long nanos, int decimals) {
    return String.format(Locale.ROOT, "%d:%02d:%s", nanos / HOUR, nanos % HOUR / MINUTE, padded(nanos, decimals));
  }

  private static String padded(long nanos, int decimals) {
    String seconds = fixed(nanos % MINUTE, decimals);
    return seconds.indexOf('.') == 1 || seconds.length() == 1 ? "0" + seconds : seconds;
  }

  /** How fast, for example {@code 0.05×}. */
  static String speed(double factor) {
    return BigDecimal.valueOf(factor).setScale(2, RoundingMode.HALF_UP).stripTrailingZeros().toPlainString() + "\u00d7";
  }

  /** A number of messages. */
  static String messages(long count) {
    return count == 1 ? "1 message" : String.format(Locale.ROOT, "%,d messages", count).replace(',', '\u202f');
  }

  /** What is added to the times of a recording, as it can be written again. */
  static String offset(long nanos) {
    BigDecimal seconds = BigDecimal.valueOf(nanos, NANO_DIGITS);
    return seconds.stripTrailingZeros().scale() <= 0 ? seconds.setScale(0).toPlainString()
        : seconds.stripTrailingZeros().toPlainString();
  }

  /** Seconds that somebody wrote, in nanoseconds; none where they are none, or too many. */
  static Optional<Long> nanos(String written) {
    String plain = written.strip().replace('\u2212', '-').replace(',', '.');
    if (!SECONDS.matcher(plain).matches()) {
      return Optional.empty();
    }
    BigDecimal nanos = new BigDecimal(plain).movePointRight(NANO_DIGITS);
    boolean held = nanos.abs().compareTo(BigDecimal.valueOf(Long.MAX_VALUE / 2)) < 0;
    return held ? Optional.of(nanos.longValue()) : Optional.empty();
  }

  private static String fixed(long nanos, int decimals) {
    return BigDecimal.valueOf(nanos, NANO_DIGITS).setScale(decimals, RoundingMode.FLOOR).toPlainString();
  }
}
