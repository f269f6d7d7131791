package org.robotui.uic.joints.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.eclipse.swt.dnd.DND;
import org.eclipse.swt.dnd.DragSource;
import org.eclipse.swt.dnd.DragSourceAdapter;
import org.eclipse.swt.dnd.DragSourceEvent;
import org.eclipse.swt.dnd.TextTransfer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.RowList;
import org.robotui.ui.control.RowOrder;
import org.robotui.ui.control.RowTable;
import org.robotui.uic.joints.internal.model.Address;
import org.robotui.uic.joints.internal.model.Export;
import org.robotui.uic.joints.internal.model.JointColumn;
import org.robotui.uic.joints.internal.model.JointRow;

/** A table with given columns: it lives until other columns are needed. Display thread. */
final class JointTable {
  private final Map<JointColumn, Column<JointRow>> columns;
  private final RowTable<JointRow> table;
  private final Consumer<String> copy;

  JointTable(Composite parent, Theme theme, JointColumns kind, Consumer<String> copy) {
    this.copy = copy;
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
    return table.order().flatMap(order -> JointColumns.which(columns, order.column()).map(column -> new Sorting(column, order.descending())));
  }

  /** Sorts as another table did, where it has that column. */
  void sort(Sorting by) {
    Optional.ofNullable(columns.get(by.column())).ifPresent(column -> table.order(new RowOrder<>(column, by.descending())));
  }

  private List<ViewAction> menu(List<JointRow> rows) {
    List<ViewAction> actions = new ArrayList<>();
    if (!rows.isEmpty()) {
      actions.add(action("yaml", "Copy as YAML", Export.yaml(rows)));
      actions.add(action("csv", "Copy as CSV", Export.csv(rows)));
      address(actions, rows, JointColumn.POSITION, "position");
      address(actions, rows, JointColumn.VELOCITY, "velocity");
      address(actions, rows, JointColumn.EFFORT, "effort");
    }
    return actions;
  }

  private void address(List<ViewAction> actions, List<JointRow> rows, JointColumn column, String name) {
    String text = addresses(rows, column);
    if (!text.isEmpty()) {
      actions.add(action(name, "Copy address of " + name + ", for a plot", text));
    }
  }

  private ViewAction action(String id, String label, String text) {
    return new ViewAction(id, label, "", Optional.empty(), () -> copy.accept(text));
  }

  private static String addresses(List<JointRow> rows, JointColumn column) {
    return rows.stream().map(row -> Address.of(row, column)).flatMap(Optional::stream).collect(Collectors.joining("\n"));
  }

  /** What is dragged is what the column under the pointer shows, of all selected rows: the press has selected the one there. */
  private void drag() {
    DragSource source = new DragSource(list().control(), DND.DROP_COPY | DND.DROP_MOVE);
    source.setTransfer(TextTransfer.getInstance());
    source.addDragListener(new DragSourceAdapter() {
      private String text = "";

      @Override
      public void dragStart(DragSourceEvent event) {
        JointColumn column = table.columnAt(event.x).flatMap(at -> JointColumns.which(columns, at)).orElse(JointColumn.POSITION);
        text = addresses(list().selected(), column);
        event.doit = !text.isEmpty();
      }

      @Override
      public void dragSetData(DragSourceEvent event) {
        event.data = text;
      }
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
