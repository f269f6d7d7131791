package org.robotui.uic.text.internal;

import java.time.Instant;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.alert.Alert;
import org.robotui.api.alert.AlertBoard;
import org.robotui.api.alert.AlertWords;

/**
 * The alerts of a robot, a line each.
 *
 * @param alerts in the order in which they matter
 * @param mutedUntil until when none is heard
 */
record Alarms(List<Alert> alerts, Optional<Instant> mutedUntil) {
  private static final AlertWords WORDS = new AlertWords(ZoneId.systemDefault());

  static Alarms of(AlertBoard board) {
    return new Alarms(board.alerts(), board.allMutedUntil());
  }

  /** The lines and a blank one, or none. */
  List<String> lines() {
    List<String> lines = new ArrayList<>();
    mutedUntil.ifPresent(until -> lines.add("all alerts are " + WORDS.muted(until)));
    alerts.forEach(alert -> lines.add(Columns.safe(line(alert))));
    if (!lines.isEmpty()) {
      lines.add("");
    }
    return lines;
  }

  private static String line(Alert alert) {
    String condition = alert.id().name().equals(alert.condition()) ? "" : " (" + alert.condition() + ")";
    return "ALERT    " + alert.id().name() + condition + "  " + alert.source() + ": " + alert.value() + "  since "
        + WORDS.since(alert) + ", "
        + WORDS.state(alert);
  }
}
