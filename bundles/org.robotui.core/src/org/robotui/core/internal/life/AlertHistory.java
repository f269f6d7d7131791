package org.robotui.core.internal.life;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.robotui.api.alert.AlertEvent;
import org.robotui.api.alert.AlertId;

/** What happened to the alerts of a RUIC: as much as somebody would read. Guarded by who has it. */
final class AlertHistory {
  static final int MOST = 500;
  /** What flutters would fill it: of the same it takes one in that time. */
  static final Duration PAUSE = Duration.ofSeconds(10);

  private final Deque<AlertEvent> events = new ArrayDeque<>();

  /** With what was kept, the oldest first. */
  AlertHistory(List<AlertEvent> kept) {
    kept.stream().skip(Math.max(0, kept.size() - MOST)).forEach(events::add);
  }

  /** Adds something that nobody did; what has just been added is not added again. */
  void happened(AlertEvent event) {
    Instant pause = event.time().minus(PAUSE);
    boolean again = events.reversed().stream().takeWhile(e -> e.time().isAfter(pause))
        .anyMatch(e -> isSame(e, event.id(), event.kind()));
    if (!again) {
      add(event);
    }
  }

  private static boolean isSame(AlertEvent event, AlertId id, AlertEvent.Kind kind) {
    return event.kind() == kind && event.id().equals(id);
  }

  /** Adds what somebody did. */
  void add(AlertEvent event) {
    events.add(event);
    if (events.size() > MOST) {
      events.removeFirst();
    }
  }

  /** The oldest first. */
  List<AlertEvent> all() {
    return List.copyOf(events);
  }
}
