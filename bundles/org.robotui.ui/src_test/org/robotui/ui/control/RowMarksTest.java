package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class RowMarksTest {
  private final RowMarks<String> marks = new RowMarks<>(row -> row.substring(0, 1));

  RowMarksTest() {
    marks.rows(List.of("a1", "b1", "c1", "d1"));
  }

  @Test
  void aRowStaysSelectedWhileItsContentAndPlaceChange() {
    marks.only(1);
    marks.rows(List.of("x1", "a2", "b2"));
    assertEquals(List.of("b2"), marks.selected());
    assertEquals(2, marks.leadIndex());
  }

  @Test
  void aSelectedRowThatGoesAndComesBackIsSelectedAgain() {
    marks.only(1);
    marks.rows(List.of("a1"));
    assertTrue(marks.selected().isEmpty());
    assertEquals(-1, marks.leadIndex());
    marks.rows(List.of("a1", "b9"));
    assertEquals(List.of("b9"), marks.selected());
  }

  @Test
  void rangesBeginWhereTheLastSelectionBegan() {
    marks.only(1);
    marks.extend(3);
    assertEquals(List.of("b1", "c1", "d1"), marks.selected());
    marks.extend(0);
    assertEquals(List.of("a1", "b1"), marks.selected());
  }

  @Test
  void singleRowsAreAddedAndLeft() {
    marks.only(0);
    marks.toggle(2);
    assertEquals(List.of("a1", "c1"), marks.selected());
    marks.toggle(0);
    assertEquals(List.of("c1"), marks.selected());
    marks.toggle(2);
    assertTrue(marks.selected().isEmpty());
    marks.toggle(2);
    assertEquals(List.of("c1"), marks.selected());
  }

  @Test
  void allAndNone() {
    marks.all();
    assertEquals(4, marks.selected().size());
    assertTrue(marks.clear());
    assertFalse(marks.clear());
  }

  @Test
  void theFirstRowSeenIsFoundAgainAfterOlderOnesWent() {
    List<Integer> before = IntStream.range(0, 1000).boxed().toList();
    List<Integer> after = IntStream.range(300, 1400).boxed().toList();
    assertEquals(200, Anchor.find(before, after, 500, i -> (Object) i));
    assertEquals(-1, Anchor.find(before, after, 100, i -> (Object) i));
    assertEquals(-1, Anchor.find(before, List.<Integer>of(), 100, i -> (Object) i));
  }
}
