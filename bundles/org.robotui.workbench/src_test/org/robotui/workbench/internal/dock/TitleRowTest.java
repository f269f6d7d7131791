package org.robotui.workbench.internal.dock;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

class TitleRowTest {
  private static final int[] WIDTHS = {50, 60, 70, 80};

  private static List<Integer> standing(int shown, int right) {
    return TitleRow.of(WIDTHS, shown, 10, right, 26).places().stream().map(TitleRow.Place::index).toList();
  }

  @Test
  void allStandWhereThereIsRoomForAll() {
    assertEquals(List.of(0, 1, 2, 3), standing(0, 270));
  }

  @Test
  void theFirstOnesStandAndTheRestIsElsewhere() {
    TitleRow row = TitleRow.of(WIDTHS, 0, 10, 269, 26);

    assertEquals(List.of(0, 1, 2), row.places().stream().map(TitleRow.Place::index).toList());
    assertEquals(List.of(3), row.others(4));
    assertEquals(190, row.right());
  }

  @Test
  void theShownOneStandsWhateverTheRoom() {
    assertEquals(List.of(0, 1, 3), standing(3, 240));
    assertEquals(List.of(3), standing(3, 20));
    assertEquals(List.of(1), standing(1, 20));
  }

  @Test
  void aTitleNeverLeavesRoomForALaterOneThatIsShorter() {
    assertEquals(List.of(1, 2), TitleRow.of(new int[]{50, 200, 10}, 0, 0, 150, 26).others(3));
  }

  @Test
  void aPlaceBelongsToTheTitleThatStandsThere() {
    TitleRow row = TitleRow.of(WIDTHS, 3, 10, 240, 26);

    assertEquals(OptionalInt.of(0), row.at(3));
    assertEquals(OptionalInt.of(1), row.at(119));
    assertEquals(OptionalInt.of(3), row.at(121));
    assertEquals(OptionalInt.empty(), row.at(201));
  }
}
