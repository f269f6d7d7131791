package org.robotui.workbench.internal.dock;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class ActionRowTest {
  private static final int[] WIDTHS = {26, 120, 26, 26};

  @Test
  void allStandWhereThereIsRoomForAll() {
    assertEquals(new ActionRow(List.of(0, 1, 2, 3), List.of()), ActionRow.of(WIDTHS, 198));
  }

  @Test
  void thoseWithWordsGoFirstAndThenTheLast() {
    assertEquals(new ActionRow(List.of(0, 2, 3), List.of(1)), ActionRow.of(WIDTHS, 197));
    assertEquals(new ActionRow(List.of(0, 2), List.of(1, 3)), ActionRow.of(WIDTHS, 77));
  }

  @Test
  void noneStandWithoutRoom() {
    assertEquals(new ActionRow(List.of(), List.of(0, 1, 2, 3)), ActionRow.of(WIDTHS, -5));
    assertEquals(new ActionRow(List.of(), List.of()), ActionRow.of(new int[0], -5));
  }
}
