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
  /** Names get at most this part of the table. */
  private static final int MOST_FOR_NAMES = 3;

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

  /**
   * Fits the columns into a width; the target has a column only while the user drives.
   *
   * @param width of the table, points
   * @param driving whether the user drives
   * @param names what the longest name needs, points; columns of less weight go rather than names are cut
   */
  public static Grid of(int width, boolean driving, int names) {
    List<JointColumn> columns = new ArrayList<>(List.of(JointColumn.values()));
    if (!driving) {
      columns.remove(JointColumn.TARGET);
    }
    int least = JointColumn.NAME.width(width);
    int wanted = Math.clamp(names, least, Math.max(least, width / MOST_FOR_NAMES));
    while (columns.stream().anyMatch(c -> c.sacrifice() > 0)) {
      JointColumn next = columns.stream().max(Comparator.comparingInt(JointColumn::sacrifice)).orElseThrow();
      int more = next.sacrifice() > JointColumn.POSITIONS ? wanted - least : 0;
      if (least(columns, width) + more <= width) {
        break;
      }
      columns.remove(next);
    }
    return new Grid(spread(columns, width, wanted - least));
  }

  private static int least(List<JointColumn> columns, int room) {
    return columns.stream().mapToInt(column -> column.width(room)).sum();
  }

  private static Map<JointColumn, Place> spread(List<JointColumn> columns, int room, int moreForNames) {
    int names = Math.clamp(room - least(columns, room), 0, moreForNames);
    int spare = Math.max(0, room - least(columns, room) - names);
    int weights = columns.stream().mapToInt(JointColumn::weight).sum();
    Map<JointColumn, Place> places = new EnumMap<>(JointColumn.class);
    int left = 0;
    for (JointColumn column : columns) {
      int width = column.width(room) + spare * column.weight() / weights + (column == JointColumn.NAME ? names : 0);
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
