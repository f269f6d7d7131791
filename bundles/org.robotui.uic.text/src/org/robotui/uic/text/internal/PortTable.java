package org.robotui.uic.text.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.robotui.api.host.PortStatus;
import org.robotui.api.port.PortKind;

/**
 * A line per port, in columns that stay where they are while the values change.
 *
 * @param ports the ports
 * @param types whether there is a column of types
 */
record PortTable(List<PortStatus> ports, boolean types) {
  private static final int STATE = 8;
  private static final int RATE = 10;
  private static final int AGE = 8;
  private static final int DROPS = 8;
  private static final int LEAST_NAME = 8;
  private static final int LEAST_VALUE = 12;
  private static final int WIDEST_TYPE = 24;
  private static final double SECONDS_PER_MINUTE = 60;
  private static final double TENTHS_UNTIL = 9.95;
  private static final double MILLIS_UNTIL = 0.0995;
  private static final String NONE = "-";

  List<String> lines(int columns) {
    int name =
        Math.clamp(widest(), LEAST_NAME, Math.max(LEAST_NAME, columns - STATE - RATE - AGE - DROPS - LEAST_VALUE - 5));
    List<String> lines = new ArrayList<>();
    lines.add(row(name, "state", "port", "type", "rate", "age", "dropped", "value"));
    ports.forEach(port -> lines.add(row(name, state(port), port.port().toString(), port.typeName(), rate(port),
        age(port.ageSeconds()), Long.toString(port.dropped()), value(port))));
    return lines;
  }

  private int widest() {
    return ports.stream().mapToInt(port -> Columns.width(Columns.safe(port.port().toString()))).max().orElse(0);
  }

  private String row(int name, String state, String port, String type, String rate, String age, String dropped,
      String value) {
    String kind = types ? Columns.left(Columns.safe(type), WIDEST_TYPE) + " " : "";
    return Columns.left(state, STATE) + " " + Columns.left(Columns.safe(port), name) + " " + kind
        + Columns.right(rate, RATE)
        + Columns.right(age, AGE) + Columns.right(dropped, DROPS) + "  " + Columns.safe(value);
  }

  /** The dot, as a word. */
  private static String state(PortStatus port) {
    if (port.stale()) {
      return "stale";
    }
    if (!port.problem().isEmpty()) {
      return "failed";
    }
    if (port.kind() != PortKind.STREAM) {
      return port.wanted() ? "ready" : "offered";
    }
    if (port.count() == 0) {
      return port.wanted() ? "waiting" : "offered";
    }
    return "ok";
  }

  private static String value(PortStatus port) {
    return port.stale() || port.problem().isEmpty() ? port.value() : port.problem();
  }

  private static String rate(PortStatus port) {
    return port.rateHz() > 0 ? String.format(Locale.ROOT, "%.1f Hz", port.rateHz()) : NONE;
  }

  private static String age(double seconds) {
    if (Double.isNaN(seconds)) {
      return NONE;
    }
    if (seconds < MILLIS_UNTIL) {
      return Math.round(seconds * 1000) + " ms";
    }
    if (seconds < SECONDS_PER_MINUTE) {
      return String.format(Locale.ROOT, seconds < TENTHS_UNTIL ? "%.1f s" : "%.0f s", seconds);
    }
    return Math.round(seconds / SECONDS_PER_MINUTE) + " min";
  }
}
