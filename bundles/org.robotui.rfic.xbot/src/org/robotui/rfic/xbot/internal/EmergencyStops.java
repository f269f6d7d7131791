package org.robotui.rfic.xbot.internal;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.Diagnostics.Level;

/**
 * What the supervisor answers of the emergency stops: a line each of state and name, with a tab between.
 *
 * @param stops in the order of the control's configuration
 */
record EmergencyStops(List<Stop> stops) {
  private static final int FIELDS = 2;
  private static final String RELEASED = "released";
  private static final String PRESSED = "pressed";

  /**
   * One of them.
   *
   * @param name in the control's configuration
   * @param state {@code released}, {@code pressed} or {@code unread}
   */
  record Stop(String name, String state) {
    private boolean isReleased() {
      return state.equals(RELEASED);
    }

    private String words() {
      return state.equals(PRESSED) ? PRESSED : "cannot be read, which counts as pressed";
    }

    private Diagnostics.Item item() {
      return new Diagnostics.Item("emergency stops/" + name, "", isReleased() ? Level.OK : Level.ERROR,
          isReleased() ? RELEASED : words() + ": all joints are safe, and nothing can be started", Map.of());
    }
  }

  EmergencyStops {
    stops = List.copyOf(stops);
  }

  /** Lines that say something else are left out. */
  static EmergencyStops read(String text) {
    return new EmergencyStops(text.lines().map(line -> line.split("\t", FIELDS))
        .filter(fields -> fields.length == FIELDS && !fields[1].isBlank())
        .map(fields -> new Stop(fields[1], fields[0])).toList());
  }

  /** As parts of the robot that say how they are. */
  Diagnostics diagnostics() {
    return new Diagnostics(stops.stream().map(Stop::item).toList());
  }

  /** Which keep the robot safe; empty where none is known to. */
  Optional<String> reason() {
    String which = stops.stream().filter(stop -> !stop.isReleased())
        .map(stop -> "'" + stop.name() + "' " + stop.words()).collect(Collectors.joining(", "));
    return Optional.of(which).filter(words -> !words.isEmpty())
        .map(words -> "emergency stop " + words + ": all joints are safe. Release it, then start plugins again");
  }
}
