package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.swt.graphics.Rectangle;
import org.junit.jupiter.api.Test;

class WindowPlacesTest {
  private static final Rectangle WIDE = new Rectangle(0, 24, 1920, 1056);

  @Test
  void whereThereIsRoomTheyLieSideBySideAndFillTheScreen() {
    assertEquals(List.of(new Rectangle(0, 24, 960, 1056), new Rectangle(960, 24, 960, 1056)),
        WindowPlaces.of(WIDE, List.of(1.0, 1.0)));
  }

  @Test
  void weightsShareTheWidth() {
    List<Rectangle> places = WindowPlaces.of(new Rectangle(0, 0, 3000, 1000), List.of(2.0, 1.0));

    assertEquals(List.of(2000, 1000), places.stream().map(r -> r.width).toList());
    assertEquals(2000, places.get(1).x);
  }

  @Test
  void whereOneWouldBeTooNarrowTheyOverlapWithinTheScreenAndNoneHidesTheTitleOfAnother() {
    Rectangle small = new Rectangle(0, 0, 1280, 800);

    List<Rectangle> places = WindowPlaces.of(small, List.of(1.0, 1.0, 1.0));

    assertTrue(places.stream().allMatch(r -> small.intersection(r).equals(r)), places::toString);
    assertTrue(places.get(1).y - places.get(0).y >= 24 && places.get(2).y - places.get(1).y >= 24, places::toString);
  }

  @Test
  void aWindowMoreOpensBesideTheOthersWhereThereIsRoom() {
    assertEquals(new Rectangle(1000, 24, 920, 980), WindowPlaces.next(WIDE, List.of(new Rectangle(0, 24, 1000, 1056))));
    assertEquals(new Rectangle(0, 24, 900, 980), WindowPlaces.next(WIDE, List.of(new Rectangle(900, 24, 1020, 1056))));
  }

  @Test
  void elseItCoversNoTitleExactlyAndStaysOnTheScreen() {
    List<Rectangle> taken = new ArrayList<>(List.of(new Rectangle(0, 24, 1600, 980)));
    for (int i = 0; i < 4; i++) {
      Rectangle next = WindowPlaces.next(WIDE, taken);
      assertEquals(next, next.intersection(WIDE));
      assertTrue(taken.stream().noneMatch(r -> Math.abs(r.y - next.y) < 24), () -> next + " over " + taken);
      taken.add(next);
    }
  }

  @Test
  void aWindowThatNobodyCouldReachIsNotPutThereAgain() {
    assertTrue(WindowPlaces.isSeen(new Rectangle(1700, 100, 900, 700), List.of(WIDE)));
    assertFalse(WindowPlaces.isSeen(new Rectangle(2000, 100, 900, 700), List.of(WIDE)),
        "the screen at the right has gone");
    assertFalse(WindowPlaces.isSeen(new Rectangle(100, -400, 900, 700), List.of(WIDE)),
        "its title is above the screen");
  }
}
