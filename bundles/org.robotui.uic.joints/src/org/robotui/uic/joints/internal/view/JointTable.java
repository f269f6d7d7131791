package org.robotui.uic.joints.internal.view;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.Subject;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.RowList;
import org.robotui.ui.control.RowOrder;
import org.robotui.ui.control.RowTable;
import org.robotui.ui.show.DraggedPorts;
import org.robotui.ui.show.PortDrag;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.joints.internal.model.Address;
import org.robotui.uic.joints.internal.model.Export;
import org.robotui.uic.joints.internal.model.JointColumn;
import org.robotui.uic.joints.internal.model.JointRow;

/** A table with given columns: it lives until other columns are needed. Display thread. */
final class JointTable {
  private final Map<JointColumn, Column<JointRow>> columns;
  private final RowTable<JointRow> table;
  private final String ruic;
  private final SubjectMenu subjects;

  JointTable(Composite parent, Theme theme, JointColumns kind, String ruic, SubjectMenu subjects) {
    this.ruic = ruic;
    this.subjects = subjects;
    columns = kind.make(theme);
    table = new RowTable<>(parent, theme, List.copyOf(columns.values()), JointRow::key);
    table.list().named("Joints").several().menu(this::menu);
    drag();
  }

  Control control() {
    return table.control();
  }

  RowTable<JointRow> table() {
    return table;
  }

  RowList<JointRow> list() {
    return table.list();
  }

  /** The column by which it is sorted, and whether downwards. */
  Optional<Sorting> sorting() {
    return table.order().flatMap(
        order -> JointColumns.which(columns, order.column()).map(column -> new Sorting(column, order.descending())));
  }

  /** Sorts as another table did, where it has that column. */
  void sort(Sorting by) {
    Optional.ofNullable(columns.get(by.column()))
        .ifPresent(column -> table.order(new RowOrder<>(column, by.descending())));
  }

  private void menu(PopupMenu menu, List<JointRow> rows) {
    if (rows.isEmpty()) {
      return;
    }
    menu.push("Copy as YAML", () -> Clipboards.copy(Export.yaml(rows)));
    menu.push("Copy as CSV", () -> Clipboards.copy(Export.csv(rows)));
    menu.line();
    quantity(menu, rows, JointColumn.POSITION, "Position");
    quantity(menu, rows, JointColumn.VELOCITY, "Velocity");
    quantity(menu, rows, JointColumn.EFFORT, "Effort");
  }

  /** What can be done with one quantity of the selected joints, as far as these come from one port. */
  private void quantity(PopupMenu menu, List<JointRow> rows, JointColumn column, String name) {
    streams(rows, column).stream().findFirst().ifPresent(stream -> subjects.fill(menu.under(name), stream));
  }

  /** A stream for each port, with the fields of its joints. */
  private static List<Subject.Stream> streams(List<JointRow> rows, JointColumn column) {
    Map<SourceId, List<String>> fields = new LinkedHashMap<>();
    rows.forEach(row -> Address.field(row, column)
        .ifPresent(field -> fields.computeIfAbsent(row.source(), s -> new ArrayList<>()).add(field)));
    return fields.entrySet().stream().map(entry -> new Subject.Stream(entry.getKey(), entry.getValue())).toList();
  }

  /**
   * What is dragged is what the column under the pointer shows, of all selected rows: the press has selected the one
   * there.
   */
  private void drag() {
    PortDrag.from(list().control(), at -> {
      JointColumn column =
          table.columnAt(at.x).flatMap(c -> JointColumns.which(columns, c)).orElse(JointColumn.POSITION);
      return Optional.of(new DraggedPorts(ruic, streams(list().selected(), column)));
    });
  }

  /**
   * How rows are sorted.
   *
   * @param column by what
   * @param descending whether downwards
   */
  record Sorting(JointColumn column, boolean descending) {}
}
