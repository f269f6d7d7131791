package org.robotui.uic.status.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ColumnsTest {
  private static final int NAME = 110;

  @Test
  void whatWasLostThenAgesThenValuesGiveWayToNames() {
    Columns wide = Columns.of(800, NAME);
    assertTrue(wide.dropped() && wide.age() && wide.value() > 0);
    Columns usual = Columns.of(460, NAME);
    assertTrue(usual.age() && usual.value() > 0 && !usual.dropped());
    Columns narrow = Columns.of(320, NAME);
    assertTrue(narrow.value() > 0 && !narrow.age());
    Columns least = Columns.of(260, NAME);
    assertEquals(0, least.value());
  }

  @Test
  void aNameKeepsItsRoom() {
    for (int width = 260; width < 900; width++) {
      int room = Columns.of(width, NAME).nameEnd() - Columns.LEAD - Columns.GAP;
      assertTrue(room >= NAME, room + " of " + width);
    }
  }

  @Test
  void columnsStandAsBeforeWhereNamesAreShort() {
    assertEquals(240, Columns.of(800, 40).nameEnd());
    assertFalse(Columns.of(200, 500).nameEnd() > 200, "the word of the state stays");
  }
}
