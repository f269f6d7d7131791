package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.api.replay.Bookmark;

class BookmarkTableTest {
  private static final long START = 1_700_000_000_000_000_000L;

  @Test
  void bookmarksStandInTheOrderOfTimeAndNotesAreKeptAsTheyAre() {
    Bookmark late = new Bookmark(START + 2_500_000_000L, "it stops, \"again\"");
    assertEquals("""
        seconds,time,note
        0.000000,2023-11-14T22:13:20Z,""
        2.500000,2023-11-14T22:13:22.500Z,"it stops, ""again\"""
        """, BookmarkTable.of(List.of(late, new Bookmark(START, "")), START));
  }
}
