package org.robotui.uic.topics.internal.view;

import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.robotui.api.port.Browser.Kind;
import org.robotui.ui.Figures;
import org.robotui.ui.ask.Measure;

/** Figures and names as this view writes them. Pure. */
public final class TopicText {
  private static final double KILO = 1000;
  private static final double WHOLE_FROM = 99.95;

  private TopicText() {}

  static String section(Kind kind) {
    return switch (kind) {
      case TOPIC -> "Topics";
      case NODE -> "Nodes";
      case SERVICE -> "Services";
      case ACTION -> "Actions";
      default -> "";
    };
  }

  static String rate(Measure measure) {
    if (measure.count() == 0) {
      return "waiting";
    }
    return measure.hertz() == 0 ? Figures.of(0, 1, "Hz") : Figures.rate(measure.hertz());
  }

  /** A time between two messages. */
  static String period(double seconds) {
    double millis = seconds * KILO;
    return Double.isNaN(seconds) ? Figures.UNKNOWN : Figures.of(millis, millis < WHOLE_FROM ? 1 : 0, "ms");
  }

  /** A number of bytes with a decimal prefix. */
  static String bytes(double count, String unit) {
    double value = count;
    String[] prefixes = {"", "k", "M", "G"};
    int prefix = 0;
    while (value >= KILO && prefix + 1 < prefixes.length) {
      value /= KILO;
      prefix++;
    }
    return Figures.of(value, prefix == 0 || value >= WHOLE_FROM ? 0 : 1, prefixes[prefix] + unit);
  }

  static String bandwidth(OptionalDouble bytesPerSecond) {
    return bytesPerSecond.isPresent() ? bytes(bytesPerSecond.getAsDouble(), "B/s") : Figures.UNKNOWN;
  }

  static String count(OptionalInt count) {
    return count.isPresent() ? Integer.toString(count.getAsInt()) : "";
  }

  /** All that was measured, in one line. */
  static String measure(Measure measure) {
    if (measure.count() == 0) {
      return "";
    }
    StringBuilder line = new StringBuilder(rate(measure));
    if (!Double.isNaN(measure.jitter())) {
      line.append("  \u00b7  ").append(period(measure.shortest())).append(" to ").append(period(measure.longest()))
          .append(", \u03c3 ").append(period(measure.jitter()));
    }
    if (measure.bytesPerSecond().isPresent()) {
      line.append("  \u00b7  ").append(bandwidth(measure.bytesPerSecond()));
    }
    measure.meanSize().ifPresent(size -> line.append("  \u00b7  ").append(bytes(size, "B")).append(" each"));
    return line.append("  \u00b7  ").append(measure.count()).append(measure.count() == 1 ? " message" : " messages")
        .toString();
  }
}
