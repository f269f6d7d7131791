package org.robotui.uic.plugins.internal.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** The columns of the list: how wide they are, and how much they matter where room is scarce. */
public enum PluginColumn {
  /** Starts and stops. */
  SWITCH("", 52, 0, 0),
  /** Of thread or plugin. */
  NAME("Thread and plugins", 170, 4, 0),
  /** Where in its life it is; for a thread its period. */
  STATE("State", 96, 0, 1),
  /** Half of all calls were not longer. */
  P50("Busy p50", 80, 0, 5),
  /** 99 of 100 calls were not longer. */
  P99("p99", 80, 0, 4),
  /** The longest call. */
  MAX("max", 88, 0, 3),
  /** The same against the period. */
  BUDGET("Of its period", 118, 1, 2),
  /** What a plugin says, and what a thread counts. */
  WORDS("Says", 170, 4, 6);

  private final String title;
  private final int width;
  private final int weight;
  private final int sacrifice;

  PluginColumn(String title, int width, int weight, int sacrifice) {
    this.title = title;
    this.width = width;
    this.weight = weight;
    this.sacrifice = sacrifice;
  }

  /** The heading. */
  public String title() {
    return title;
  }

  /** Whether its figures stand at the right. */
  public boolean isFigure() {
    return this == P50 || this == P99 || this == MAX;
  }

  /**
   * From where to where a column goes.
   *
   * @param left its left edge, points
   * @param width how wide it is, points
   */
  public record Place(int left, int width) {}

  /** Fits the columns into a width. */
  public static Map<PluginColumn, Place> places(int room) {
    List<PluginColumn> columns = new ArrayList<>(List.of(values()));
    while (least(columns) > room && columns.stream().anyMatch(c -> c.sacrifice > 0)) {
      columns.remove(columns.stream().max(Comparator.comparingInt(c -> c.sacrifice)).orElseThrow());
    }
    int spare = Math.max(0, room - least(columns));
    int weights = columns.stream().mapToInt(c -> c.weight).sum();
    Map<PluginColumn, Place> places = new EnumMap<>(PluginColumn.class);
    int left = 0;
    for (PluginColumn column : columns) {
      Place place = new Place(left, column.width + spare * column.weight / weights);
      places.put(column, place);
      left += place.width();
    }
    return places;
  }

  private static int least(List<PluginColumn> columns) {
    return columns.stream().mapToInt(c -> c.width).sum();
  }

  /** What stands in a cell; empty where it is painted. */
  public String text(Line line) {
    return switch (this) {
      case SWITCH, BUDGET -> "";
      case NAME -> line.name();
      case STATE -> line.word();
      case P50 -> Durations.of(line.busy().p50());
      case P99 -> Durations.of(line.busy().p99());
      case MAX -> line.busy().longest();
      case WORDS -> line.words();
    };
  }
}
