package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.api.replay.TimeRange;

class TimeScaleTest {
  private static final long BEGIN = 1_700_000_000_000_000_000L;
  private static final long SECOND = 1_000_000_000L;
  private static final TimeRange ALL = new TimeRange(BEGIN, BEGIN + 1000 * SECOND);

  @Test
  void placesAndTimesFitTogether() {
    TimeScale scale = new TimeScale(ALL, 100, 500);
    assertEquals(100, scale.x(BEGIN));
    assertEquals(600, scale.x(ALL.end()));
    assertEquals(350, scale.x(BEGIN + 500 * SECOND));
    for (int x = 100; x <= 600; x++) {
      assertEquals(x, scale.x(scale.time(x)));
    }
    assertEquals(2 * SECOND, scale.point());
  }

  @Test
  void whatIsFarOutsideIsStillAPlaceForPainting() {
    TimeScale scale = new TimeScale(new TimeRange(BEGIN, BEGIN + 100), 0, 500);
    assertEquals(1000, scale.x(Long.MAX_VALUE));
    assertEquals(-500, scale.x(Long.MIN_VALUE));
  }

  @Test
  void aZoomLeavesTheTimeAtThePointerWhereItIs() {
    TimeScale scale = new TimeScale(ALL, 100, 500);
    for (int x : new int[]{100, 233, 350, 600}) {
      TimeScale near = new TimeScale(scale.zoomed(x, 4, ALL), 100, 500);
      assertEquals(250 * SECOND, near.shown().length());
      assertEquals(scale.time(x), near.time(x), 2);
    }
  }

  @Test
  void thereIsNoMoreThanAllAndNoLessThanCanBeToldApart() {
    TimeScale scale = new TimeScale(ALL, 0, 500);
    assertEquals(ALL, scale.zoomed(250, 0.01, ALL));
    TimeRange least = scale.zoomed(250, 1e15, ALL);
    assertEquals(TimeScale.LEAST, least.length());
    assertEquals(new TimeRange(5, 5), new TimeScale(new TimeRange(5, 5), 0, 500).zoomed(1, 2, new TimeRange(5, 5)));
  }

  @Test
  void panningEndsWhereTheTimeEnds() {
    TimeRange half = new TimeRange(BEGIN + 100 * SECOND, BEGIN + 600 * SECOND);
    TimeScale scale = new TimeScale(half, 0, 500);
    assertEquals(new TimeRange(BEGIN + 110 * SECOND, BEGIN + 610 * SECOND), scale.panned(10, ALL));
    assertEquals(new TimeRange(BEGIN, BEGIN + 500 * SECOND), scale.panned(-4000, ALL));
    assertEquals(new TimeRange(BEGIN + 500 * SECOND, ALL.end()), scale.panned(4000, ALL));
  }

  @Test
  void aPageIsTurnedOnlyWhereThePositionHasLeftIt() {
    TimeRange part = new TimeRange(BEGIN + 100 * SECOND, BEGIN + 200 * SECOND);
    TimeScale scale = new TimeScale(part, 0, 500);
    assertEquals(part, scale.paged(BEGIN + 150 * SECOND, ALL));
    TimeRange next = scale.paged(BEGIN + 201 * SECOND, ALL);
    assertEquals(BEGIN + 191 * SECOND, next.start());
    assertEquals(part.length(), next.length());
    assertTrue(scale.paged(BEGIN, ALL).start() == BEGIN);
  }
}
