package org.robotui.core.internal.config.model;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.alert.AlertEvent;
import org.robotui.api.alert.AlertId;

/**
 * What is kept of the alerts of a RUIC from one run to the next.
 *
 * @param muted until when single ones are not heard
 * @param allMuted until when none is heard
 * @param history what happened, the oldest first
 */
public record KeptAlerts(Map<AlertId, Instant> muted, Optional<Instant> allMuted, List<AlertEvent> history) {
  /** Nothing. */
  public static final KeptAlerts NONE = new KeptAlerts(Map.of(), Optional.empty(), List.of());
}
