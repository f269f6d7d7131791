package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Comparator;
import java.util.List;
import org.junit.jupiter.api.Test;

class ColumnWidthsTest {
  private static final Column<String> NAME =
      Column.<String>words("Name", s -> s).weight(2).order(Comparator.naturalOrder());
  private static final Column<String> VALUE = Column.words("Value", String::strip);
  private static final Column<String> RATE =
      Column.<String>figures("Rate", s -> s).width(60).order(Comparator.comparing(String::length));
  private static final Column<String> RARE = Column.<String>figures("Rare", s -> s).width(50).from(400);

  private final ColumnWidths widths = new ColumnWidths(List.of(NAME, RATE, VALUE, RARE));

  @Test
  void fixedWidthsComeFirstAndWeightsShareTheRest() {
    assertArrayEquals(new int[]{0, 260, 320, 450, 500}, widths.edges(500));
  }

  @Test
  void aColumnWithoutRoomIsLeftOut() {
    assertArrayEquals(new int[]{0, 160, 220, 300, 300}, widths.edges(300));
  }

  @Test
  void aDraggedColumnKeepsItsWidthUntilReset() {
    widths.drag(0, 100);
    assertArrayEquals(new int[]{0, 100, 160, 450, 500}, widths.edges(500));
    widths.drag(0, -20);
    assertEquals(ColumnWidths.LEAST, widths.edges(500)[1]);
    widths.reset(0);
    assertEquals(260, widths.edges(500)[1]);
  }

  @Test
  void theLastColumnFillsWhatAllDraggedOnesLeave() {
    widths.drag(0, 50);
    widths.drag(2, 50);
    assertArrayEquals(new int[]{0, 50, 110, 160, 500}, widths.edges(500));
    assertArrayEquals(new int[]{0, 50, 110, 300, 300}, widths.edges(300));
  }

  @Test
  void aClickSortsAscendingThenDescendingAndAnotherColumnBeginsAnew() {
    RowOrder<String> first = new RowOrder<>(NAME, false);
    assertEquals(List.of("a", "bb", "c"), first.sort(List.of("c", "a", "bb")));
    RowOrder<String> second = first.clicked(NAME);
    assertEquals(List.of("c", "bb", "a"), second.sort(List.of("c", "a", "bb")));
    assertEquals(new RowOrder<>(NAME, false), second.clicked(NAME));
    assertEquals(List.of("c", "a", "bb"), second.clicked(RATE).sort(List.of("bb", "c", "a")));
  }
}
