package org.robotui.uic.alerts.internal;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.robotui.api.alert.Alert;
import org.robotui.api.alert.AlertEvent;

/**
 * What the view shows.
 *
 * @param alerts in the order in which they matter
 * @param mutedUntil until when none is heard; empty where they are heard
 * @param snooze for how long one press mutes, minutes
 * @param history what happened, the newest first
 */
record Page(List<Alert> alerts, Optional<Instant> mutedUntil, long snooze, List<AlertEvent> history) {
  /** How many wait for somebody. */
  long waiting() {
    return alerts.stream().filter(Alert::isNew).count();
  }

  /** What stands at the right of the view's title. */
  String note() {
    return alerts.isEmpty() ? "" : waiting() + " new of " + alerts.size();
  }
}
