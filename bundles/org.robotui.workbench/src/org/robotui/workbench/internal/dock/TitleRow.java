package org.robotui.workbench.internal.dock;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;

/**
 * Which titles stand in a line: all where there is room, else as many as fit, of which the shown one is always one.
 *
 * @param places of the titles that stand there, from left to right
 * @param right where the last one ends
 */
record TitleRow(List<Place> places, int right) {
  /**
   * One title.
   *
   * @param index of all titles
   * @param left where it begins
   * @param right where the next one begins
   */
  record Place(int index, int left, int right) {}

  TitleRow {
    places = List.copyOf(places);
  }

  /**
   * Lays titles out.
   *
   * @param widths of all titles, each with the room to the next
   * @param shown which one is shown
   * @param left where the first one begins
   * @param right where the last one has to end
   * @param more what the button takes by which the others are reached
   */
  static TitleRow of(int[] widths, int shown, int left, int right, int more) {
    boolean all = left + Arrays.stream(widths).sum() <= right;
    int room = right - left - (all ? 0 : more + widths[shown]);
    List<Place> places = new ArrayList<>();
    int x = left;
    boolean full = false;
    for (int i = 0; i < widths.length; i++) {
      boolean fits = all || !full && widths[i] <= room;
      full = !fits && i != shown;
      if (fits || i == shown) {
        places.add(new Place(i, x, x + widths[i]));
        x += widths[i];
        room -= i == shown ? 0 : widths[i];
      } else if (i > shown) {
        break;
      }
    }
    return new TitleRow(places, x);
  }

  /** Which title is at a place; what lies before the first one belongs to it. */
  OptionalInt at(int x) {
    return places.stream().filter(place -> x < place.right()).mapToInt(Place::index).findFirst();
  }

  /** Which of so many titles do not stand there. */
  List<Integer> others(int count) {
    List<Integer> others = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      int index = i;
      if (places.stream().noneMatch(place -> place.index() == index)) {
        others.add(i);
      }
    }
    return others;
  }
}
