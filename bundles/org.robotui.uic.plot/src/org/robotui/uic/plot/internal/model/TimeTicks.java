package org.robotui.uic.plot.internal.model;

import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.robotui.ui.Figures;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/** Round times along a time axis. */
public final class TimeTicks {
  /** One of them. */
  public record Tick(long time, String label) {}

  private static final long SECOND = TimeSpan.SECOND;
  private static final long MINUTE = 60 * SECOND;
  private static final long HOUR = 60 * MINUTE;
  private static final long DAY = 24 * HOUR;
  private static final long[] LONG_STEPS = {
      SECOND, 2 * SECOND, 5 * SECOND, 10 * SECOND, 15 * SECOND, 30 * SECOND, MINUTE, 2 * MINUTE, 5 * MINUTE,
      10 * MINUTE, 15 * MINUTE,
      30 * MINUTE, HOUR, 2 * HOUR, 3 * HOUR, 6 * HOUR, 12 * HOUR, DAY, 2 * DAY, 7 * DAY, 14 * DAY, 30 * DAY
  };
  /** Below that, times are those of a simulation, counted from its beginning. */
  private static final long MOST_DAYS = Long.MAX_VALUE / DAY;
  private static final long FIRST_CALENDAR = 10L * 365 * DAY;

  private TimeTicks() {}

  /** Before the end of the span: what is seen live. They stand still while time goes on. */
  public static List<Tick> relative(TimeSpan span, int most) {
    long step = step(span.length(), most);
    List<Tick> ticks = new ArrayList<>();
    for (long i = bounded(span.length() / step, most); i >= 0; i--) {
      long back = i * step;
      ticks.add(new Tick(span.to() - back, back == 0 ? "now" : duration(-back, step)));
    }
    return ticks;
  }

  /** By the clock: what is looked at. */
  public static List<Tick> absolute(TimeSpan span, int most, ZoneId zone) {
    long step = step(span.length(), most);
    long shift = span.from() < FIRST_CALENDAR ? 0 : offset(span.from(), zone);
    List<Tick> ticks = new ArrayList<>();
    long first = Math.ceilDiv(span.from() + shift, step) * step - shift;
    long last = first > span.to() ? -1 : bounded((span.to() - first) / step, most);
    for (long i = 0; i <= last; i++) {
      ticks.add(new Tick(first + i * step, clock(first + i * step, step, zone)));
    }
    return ticks;
  }

  /** Times from robots may lie at either end of what a number holds, where differences are no differences any more. */
  private static long bounded(long count, int most) {
    return Math.clamp(count, 0, Math.max(1, most) + 1);
  }

  /** A time as exact as a step tells apart. */
  public static String clock(long time, long step, ZoneId zone) {
    if (Math.abs(time) < FIRST_CALENDAR) {
      return Figures.of(time / (double) SECOND, decimals(step), "s");
    }
    String pattern = step >= DAY ? "yyyy-MM-dd"
        : step >= MINUTE ? "HH:mm"
            : step >= SECOND ? "HH:mm:ss"
                : "HH:mm:ss." + "S".repeat(Math.max(1, decimals(step)));
    Instant instant = Instant.ofEpochSecond(Math.floorDiv(time, SECOND), Math.floorMod(time, SECOND));
    return DateTimeFormatter.ofPattern(pattern, Locale.ROOT).format(instant.atZone(zone));
  }

  /** A length of time, for example {@code −1.5 s}, {@code −2 min}, {@code −1:30 min}. */
  static String duration(long nanos, long step) {
    long size = Math.abs(nanos);
    String sign = nanos < 0 ? "\u2212" : "";
    if (size < MINUTE || step < SECOND || size < 5 * MINUTE && step % MINUTE != 0) {
      return sign + Figures.of(size / (double) SECOND, decimals(step), "s");
    }
    if (size < 2 * HOUR) {
      return sign + mixed(size / MINUTE, size % MINUTE / SECOND, step < MINUTE) + "\u00a0min";
    }
    return sign + mixed(size / HOUR, size % HOUR / MINUTE, step < HOUR) + "\u00a0h";
  }

  static long step(long length, int most) {
    long least = Math.max(1, Math.ceilDiv(length, (long) Math.max(1, most)));
    for (long step : LONG_STEPS) {
      if (step >= least && least > SECOND / 2) {
        return step;
      }
    }
    return least > SECOND ? Math.min(Math.ceilDiv(least, DAY), MOST_DAYS) * DAY
        : Math.max(1, Math.round(Figures.roundStep(least)));
  }

  static int decimals(long step) {
    int decimals = 0;
    for (long unit = SECOND; decimals < 9 && step % unit != 0; unit /= 10) {
      decimals++;
    }
    return decimals;
  }

  private static String mixed(long whole, long part, boolean both) {
    return both ? String.format(Locale.ROOT, "%d:%02d", whole, part) : Long.toString(whole);
  }

  private static long offset(long time, ZoneId zone) {
    return zone.getRules().getOffset(Instant.ofEpochSecond(time / SECOND)).getTotalSeconds() * SECOND;
  }
}
