package org.robotui.ui.control;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Shares the width of a table among its columns. Pure. */
final class ColumnWidths {
  static final int LEAST = 32;

  private final List<? extends Column<?>> columns;
  private final Map<Integer, Integer> dragged = new HashMap<>();

  ColumnWidths(List<? extends Column<?>> columns) {
    this.columns = columns;
  }

  /** The user made a column this wide. */
  void drag(int column, int points) {
    dragged.put(column, Math.max(LEAST, points));
  }

  /** A column is as wide as at first. */
  void reset(int column) {
    dragged.remove(column);
  }

  /** The left edges of all columns and the right edge of the last; a column that is left out has no width. */
  int[] edges(int total) {
    int[] edges = new int[columns.size() + 1];
    double rest = total - IntStream.range(0, columns.size()).map(i -> fixed(i, total)).sum();
    double weights = IntStream.range(0, columns.size()).mapToDouble(i -> weight(i, total)).sum();
    double at = 0;
    for (int i = 0; i < columns.size(); i++) {
      double weight = weight(i, total);
      at += weight > 0 ? Math.max(LEAST, rest * weight / weights) : fixed(i, total);
      edges[i + 1] = (int) Math.round(at);
    }
    return stretched(edges, total);
  }

  private static int[] stretched(int[] edges, int total) {
    int last = edges.length - 1;
    while (last > 1 && edges[last - 1] == edges[last]) {
      last--;
    }
    for (int i = last; i < edges.length; i++) {
      edges[i] = Math.max(edges[i], total);
    }
    return edges;
  }

  private boolean shown(int column, int total) {
    return total >= columns.get(column).needed();
  }

  private int fixed(int column, int total) {
    if (!shown(column, total) || weight(column, total) > 0) {
      return 0;
    }
    return dragged.getOrDefault(column, columns.get(column).width());
  }

  private double weight(int column, int total) {
    return shown(column, total) && !dragged.containsKey(column) ? columns.get(column).weight() : 0;
  }
}
