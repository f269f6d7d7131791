package org.robotui.workbench.internal.pane;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.RowTable;
import org.robotui.workbench.internal.model.ExchangeRow;

/**
 * What would become of every connection. The menu of a port that several fit connects it to one of them. Display thread
 * only.
 */
final class MatchingTable {
  private final RowTable<ExchangeRow> table;
  private final BiConsumer<SourceId, SourceId> choose;
  private List<ExchangeRow> shown = List.of();

  MatchingTable(Composite parent, Theme theme, BiConsumer<SourceId, SourceId> choose) {
    this.choose = choose;
    table = new RowTable<>(parent, theme, List.of(
        Column.<ExchangeRow>words("State", ExchangeRow::state).dot(ExchangeRow::health).role(r -> r.health().role())
            .width(104).weight(0),
        Column.<ExchangeRow>words("View port", r -> r.port().toString()).hint(ExchangeRow::type).weight(1.1),
        Column.<ExchangeRow>words("Now", ExchangeRow::now).role(Role.DIM).weight(1),
        Column.<ExchangeRow>words("Then", ExchangeRow::then).weight(1),
        Column.<ExchangeRow>words("Why", ExchangeRow::why).role(Role.DIM).weight(1.9)),
        r -> r.kind() + " " + r.port());
    table.list().named("What would become of the connections").menu(this::actions);
    message(Health.NONE, "Not tried yet", "Choose a framework and say where the robot is, then press Try.");
  }

  Control control() {
    return table.control();
  }

  void show(List<ExchangeRow> rows) {
    if (!rows.equals(shown)) {
      shown = rows;
      table.list().noMessage();
      table.show(rows);
    }
  }

  void message(Health health, String title, String sentence) {
    shown = List.of();
    table.show(List.of());
    table.list().message(health, title, sentence);
  }

  private List<ViewAction> actions(List<ExchangeRow> rows) {
    return rows.stream().limit(1).flatMap(r -> r.candidates().stream().map(c -> action(r, c))).toList();
  }

  private ViewAction action(ExchangeRow row, SourceId candidate) {
    return new ViewAction("connect " + candidate, "Connect to " + candidate, "", Optional.empty(),
        () -> choose.accept(row.port(), candidate));
  }
}
