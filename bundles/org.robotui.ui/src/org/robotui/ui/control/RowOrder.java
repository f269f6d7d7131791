package org.robotui.ui.control;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;

/**
 * The order that the user chose for the rows of a table. Immutable, so that a view's tick can sort by it.
 *
 * @param column the column sorted by; it has an order
 * @param descending whether the greatest comes first
 * @param <R> a row
 */
public record RowOrder<R>(Column<R> column, boolean descending) {
  /**
   * Compares rows.
   *
   * @return the order
   */
  public Comparator<R> comparator() {
    Comparator<R> ascending = column.order().orElseThrow();
    return descending ? ascending.reversed() : ascending;
  }

  /**
   * Sorts. Rows that are equal in this order keep theirs.
   *
   * @param rows in any order
   * @return a new, immutable list
   */
  public List<R> sort(Collection<R> rows) {
    List<R> sorted = new ArrayList<>(rows);
    sorted.sort(comparator());
    return List.copyOf(sorted);
  }

  /** What a click on a column's heading makes of the order: ascending, then descending. */
  RowOrder<R> clicked(Column<R> heading) {
    return new RowOrder<>(heading, heading == column && !descending);
  }
}
