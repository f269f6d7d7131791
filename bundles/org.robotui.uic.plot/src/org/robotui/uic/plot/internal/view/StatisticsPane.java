package org.robotui.uic.plot.internal.view;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.RowTable;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.StatisticsRow;

/** Statistics of what is seen, or of what lies between the cursors, a row for each trace. Display thread. */
final class StatisticsPane {
  private static final int HEAD = 26;
  private static final int ROW = 26;
  private static final int MOST_ROWS = 6;
  private static final double NAME_SHARE = 1.6;
  private static final String LEAST_WANTED = "Rate [Hz]";
  private static final int ROOM = 560;
  private static final int CALM_MILLIS = 200;

  private final RowTable<StatisticsRow> table;
  private final Runnable again;
  private boolean calm;

  /** Given also what shows it once more. */
  StatisticsPane(Composite parent, Theme theme, Runnable again) {
    this.again = again;
    List<Column<StatisticsRow>> columns = new ArrayList<>();
    columns.add(Column.words("Trace", StatisticsRow::name).weight(NAME_SHARE));
    StatisticsRow.FIGURES.forEach(figure -> columns.add(Column.figures(figure.title(), figure.text())
        .weight(1).from(figure.title().equals(LEAST_WANTED) ? ROOM : 0)
        .order(Comparator.comparing(figure.number()))));
    table = new RowTable<>(parent, theme, columns, StatisticsRow::ref);
    table.onOrder(again).control().setVisible(false);
    table.list().named("Statistics").several().menu((menu, rows) -> {
      menu.push("Copy all", this::copy);
    });
  }

  Control control() {
    return table.control();
  }

  boolean isOpen() {
    return table.control().getVisible();
  }

  void open(boolean shown) {
    table.control().setVisible(shown);
  }

  /** How high it is where there is so much room. */
  int height(PlotScene scene, int room) {
    long rows = scene.traces().filter(t -> t.drawn()).count();
    return isOpen() ? Math.min(room / 2, HEAD + ROW * (int) Math.clamp(rows, 1, MOST_ROWS)) : 0;
  }

  /** Computes them anew, at once or as often as one can read. */
  void show(PlotScene scene, PlotState state, boolean now) {
    if (isOpen() && now) {
      table.show(table.sorted(rows(scene, state)));
    } else if (isOpen() && !calm) {
      calm = true;
      table.control().getDisplay().timerExec(CALM_MILLIS, () -> {
        calm = false;
        if (!table.control().isDisposed()) {
          again.run();
        }
      });
    }
  }

  private static List<StatisticsRow> rows(PlotScene scene, PlotState state) {
    return StatisticsRow.of(scene, axis -> state.measured(scene, axis));
  }

  /** As a table with headings. */
  private void copy() {
    Clipboards.copy(StatisticsRow.table(table.list().rows()));
  }

  /** The same of what may not be shown. */
  static void copy(PlotScene scene, PlotState state) {
    Clipboards.copy(StatisticsRow.table(rows(scene, state)));
  }
}
