package org.robotui.uic.alerts.internal;

import java.util.Comparator;
import java.util.List;
import org.robotui.api.alert.Alert;
import org.robotui.api.alert.AlertWords;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.control.Column;

/**
 * The columns of the list.
 *
 * @param words says what is so
 */
record AlertColumns(AlertWords words) {
  private static final int TIME_WIDTH = 84;
  private static final int ROOM_FOR_STATE = 420;
  private static final int ROOM_FOR_SOURCE = 560;
  private static final int ROOM_FOR_CONDITION = 760;
  private static final double SEEN_SHARE = 1.4;
  private static final double STATE_SHARE = 1.1;
  private static final double SOURCE_SHARE = 0.8;

  List<Column<Alert>> all() {
    return List.of(
        Column.<Alert>words("Alert", alert -> alert.id().name()).dot(AlertColumns::health).role(AlertColumns::role)
            .order(Comparator.comparing(alert -> alert.id().name())),
        Column.<Alert>words("Seen", Alert::value).weight(SEEN_SHARE).role(AlertColumns::role),
        Column.<Alert>words("At", Alert::source).weight(SOURCE_SHARE).role(Role.DIM).from(ROOM_FOR_SOURCE)
            .order(Comparator.comparing(Alert::source)),
        Column.<Alert>words("Condition", Alert::condition).role(Role.DIM).from(ROOM_FOR_CONDITION),
        Column.<Alert>figures("Since", words::since).width(TIME_WIDTH).role(AlertColumns::role)
            .order(Comparator.comparing(Alert::since)),
        Column.<Alert>words("State", words::state).weight(STATE_SHARE).role(AlertColumns::role).from(ROOM_FOR_STATE)
            .order(Comparator.comparing(words::state)));
  }

  /** The dot: what waits for somebody is a fault while it lasts. */
  static Health health(Alert alert) {
    if (!alert.lasting()) {
      return Health.WAITING;
    }
    return alert.isNew() ? Health.BAD : Health.WARNING;
  }

  private static Role role(Alert alert) {
    return alert.lasting() ? Role.TEXT : Role.DIM;
  }
}
