package org.robotui.ui.ask;

import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.RowTable;

/** The questions that were asked. Choosing one shows again what came back. Display thread. */
final class AskHistory {
  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("HH:mm:ss").withZone(ZoneId.systemDefault());
  private static final int TIME_WIDTH = 92;
  private static final int ROOM_FOR_TIME = 260;
  private static final double MILLIS = 1e3;

  private final RowTable<Asked> table;
  private Optional<Long> chosen = Optional.empty();
  private List<Asked> rows = List.of();

  AskHistory(Composite parent, Theme theme, Runnable looked) {
    table = new RowTable<>(parent, theme, List.of(
        Column.<Asked>values("Asked", a -> TIME.format(a.at())).width(TIME_WIDTH).role(Role.DIM).from(ROOM_FOR_TIME),
        Column.<Asked>words("Name", a -> a.entry().item().name()).weight(2).dot(Asked::health),
        Column.<Asked>words("Outcome", Asked::words).weight(3).role(Role.DIM),
        Column.<Asked>figures("Took", AskHistory::took)), Asked::number);
    table.list().named("Questions").onSelect(selected -> {
      chosen = selected.stream().findFirst().map(Asked::number);
      looked.run();
    });
  }

  static String took(Asked asked) {
    double seconds = asked.took().toNanos() / 1e9;
    return seconds < 1 ? Figures.of(seconds * MILLIS, 0, "ms") : Figures.of(seconds, 1, "s");
  }

  /** Follows the newest question again. */
  void newest() {
    chosen = Optional.empty();
    table.list().selectNone();
  }

  void show(List<Asked> all) {
    rows = all;
    table.show(all);
    if (all.isEmpty()) {
      table.list().message(Health.NONE, "Nothing asked yet", "Calls are listed here, with their results.");
    } else {
      table.list().noMessage();
    }
  }

  /** The question that the user wants to see again. */
  Optional<Asked> chosen() {
    return chosen.flatMap(n -> rows.stream().filter(a -> a.number() == n).findFirst());
  }
}
