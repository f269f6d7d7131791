package org.robotui.uic.jointcontrol.internal.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Where the columns stand. What matters least is left out where room is scarce.
 *
 * @param places by column, in the order shown
 */
public record Grid(Map<JointColumn, Place> places) {
  /**
   * From where to where a column goes.
   *
   * @param left its left edge, points
   * @param width how wide it is, points
   */
  public record Place(int left, int width) {
    boolean contains(int x) {
      return x >= left && x < left + width;
    }
  }

  /** Fits the columns into a width; the target has a column only while the user drives. */
  public static Grid of(int width, boolean driving) {
    List<JointColumn> columns = new ArrayList<>(List.of(JointColumn.values()));
    if (!driving) {
      columns.remove(JointColumn.TARGET);
    }
    while (least(columns, width) > width && columns.stream().anyMatch(c -> c.sacrifice() > 0)) {
      columns.remove(columns.stream().max(Comparator.comparingInt(JointColumn::sacrifice)).orElseThrow());
    }
    return new Grid(spread(columns, width));
  }

  private static int least(List<JointColumn> columns, int room) {
    return columns.stream().mapToInt(column -> column.width(room)).sum();
  }

  private static Map<JointColumn, Place> spread(List<JointColumn> columns, int room) {
    int spare = Math.max(0, room - least(columns, room));
    int weights = columns.stream().mapToInt(JointColumn::weight).sum();
    Map<JointColumn, Place> places = new EnumMap<>(JointColumn.class);
    int left = 0;
    for (JointColumn column : columns) {
      int width = column.width(room) + spare * column.weight() / weights;
      places.put(column, new Place(left, width));
      left += width;
    }
    return places;
  }

  /** The column at a place. */
  public Optional<JointColumn> at(int x) {
    return places.entrySet().stream().filter(e -> e.getValue().contains(x)).map(Map.Entry::getKey).findFirst();
  }

  /** Where a column stands, where it is shown. */
  public Optional<Place> find(JointColumn column) {
    return Optional.ofNullable(places.get(column));
  }
}
