package org.robotui.uic.alerts.internal;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.robotui.api.alert.AlertEvent;
import org.robotui.api.alert.AlertWords;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.control.Column;

/**
 * The columns of the history.
 *
 * @param words says what happened
 */
record EventColumns(AlertWords words) {
  private static final int TIME_WIDTH = 130;
  private static final int ROOM_FOR_BY = 420;
  private static final int ROOM_FOR_SOURCE = 620;
  private static final double WHAT_SHARE = 1.6;
  private static final String ALL = "all alerts";

  List<Column<AlertEvent>> all() {
    return List.of(
        Column.<AlertEvent>figures("Time", event -> words.time(event.time())).width(TIME_WIDTH).role(Role.DIM)
            .order(Comparator.comparing(AlertEvent::time)),
        Column.<AlertEvent>words("Alert", EventColumns::name).dot(EventColumns::health)
            .order(Comparator.comparing(EventColumns::name)),
        Column.<AlertEvent>words("What", words::what).weight(WHAT_SHARE).order(Comparator.comparing(words::what)),
        Column.<AlertEvent>words("At", AlertEvent::source).role(Role.DIM).from(ROOM_FOR_SOURCE)
            .order(Comparator.comparing(AlertEvent::source)),
        Column.<AlertEvent>words("By", AlertEvent::by).role(Role.DIM).from(ROOM_FOR_BY)
            .order(Comparator.comparing(AlertEvent::by)));
  }

  /** Whether all words of a filter stand in what is said of an event. */
  boolean fits(AlertEvent event, String filter) {
    String said = String.join(" ", words.time(event.time()), name(event), words.what(event), event.source(), event.by())
        .toLowerCase(Locale.ROOT);
    return filter.toLowerCase(Locale.ROOT).lines().flatMap(line -> List.of(line.trim().split("\\s+")).stream())
        .allMatch(said::contains);
  }

  static String name(AlertEvent event) {
    return event.id().name().isEmpty() ? ALL : event.id().name();
  }

  private static Health health(AlertEvent event) {
    return switch (event.kind()) {
      case BEGAN -> Health.BAD;
      case ENDED -> Health.OK;
      case ACKNOWLEDGED, MUTED, UNMUTED -> Health.NONE;
    };
  }
}
