package org.robotui.uic.log.internal.model;

import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import org.robotui.data.status.Severity;

/** Entries in words, for the list, the clipboard and files. Pure, for all threads. */
public final class Wording {
  private static final long NANOS_PER_SECOND = 1_000_000_000L;
  // Clocks of simulators begin near zero; nothing was recorded before 1980.
  private static final long FIRST_DATE_NANOS = 315_532_800L * NANOS_PER_SECOND;
  private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("HH:mm:ss.SSS", Locale.ROOT);
  private static final DateTimeFormatter DATE = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss.SSS", Locale.ROOT);

  private final ZoneId zone;

  /** In a time zone. */
  public Wording(ZoneId zone) {
    this.zone = zone;
  }

  /** The word of a severity, as wide as the others. */
  public static String word(Severity severity) {
    return switch (severity) {
      case DEBUG -> "Debug";
      case INFO -> "Info";
      case WARNING -> "Warn";
      case ERROR -> "Error";
      case FATAL -> "Fatal";
    };
  }

  /** The time of day, or seconds of a simulator's clock. */
  public String time(Entry entry) {
    return written(entry.nanos(), TIME);
  }

  /** Date and time, or seconds of a simulator's clock. */
  public String date(Entry entry) {
    return written(entry.nanos(), DATE);
  }

  /** One entry as text: all of its lines, the further ones indented. */
  public String text(LogLine line) {
    Entry e = line.last();
    String again = line.count() > 1 ? " (" + line.count() + " times since " + date(line.first()) + ")" : "";
    String where = e.location().isEmpty() ? "" : "  (" + e.location() + ")";
    return date(e) + "  " + String.format(Locale.ROOT, "%-5s", word(e.severity()).toUpperCase(Locale.ROOT)) + "  ["
        + e.origin() + "]  "
        + whole(e).stripTrailing().replace("\n", "\n    ") + where + again;
  }

  /** The message, and what was not kept of it. */
  public static String whole(Entry entry) {
    return entry.cut() == 0 ? entry.message()
        : entry.message() + "\n[" + String.format(Locale.ROOT, "%,d", entry.cut()).replace(',', ' ')
            + " further characters were not kept]";
  }

  private String written(long nanos, DateTimeFormatter form) {
    if (nanos < FIRST_DATE_NANOS) {
      return String.format(Locale.ROOT, "%.3f s", nanos / (double) NANOS_PER_SECOND);
    }
    return form.format(Instant.ofEpochSecond(nanos / NANOS_PER_SECOND, nanos % NANOS_PER_SECOND).atZone(zone));
  }
}
