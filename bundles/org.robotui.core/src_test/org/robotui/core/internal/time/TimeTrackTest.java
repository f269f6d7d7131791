package org.robotui.core.internal.time;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class TimeTrackTest {
  private static final long SECOND = 1_000_000_000L;
  /** Clocks of machines may start below zero, and wrap around. */
  private static final long START = Long.MAX_VALUE - SECOND;
  private static final long RECORDED = 1_700_000_000L * SECOND;

  private final TimeTrack track = new TimeTrack();

  private void play(long fromMoment, long fromTime, double speed, int seconds) {
    for (int step = 0; step <= 20 * seconds; step++) {
      track.add(fromMoment + step * SECOND / 20, fromTime + Math.round(step * speed * SECOND / 20));
    }
  }

  @Test
  void timePassesAsFastAsItWasPlayedAndNotWhileItStood() {
    track.begin(START, RECORDED);
    play(START, RECORDED, 10, 4);
    play(START + 9 * SECOND, RECORDED + 40 * SECOND, 0.5, 4);
    assertEquals(RECORDED + 15 * SECOND, track.time(START + 3 * SECOND / 2), 1000);
    assertEquals(RECORDED + 40 * SECOND, track.time(START + 7 * SECOND), 1000);
    assertEquals(RECORDED + 41 * SECOND, track.time(START + 11 * SECOND), 1000);
    assertEquals(START + 2 * SECOND - START, track.moment(RECORDED + 20 * SECOND) - START, 1000);
    assertEquals(START + 11 * SECOND - START, track.moment(RECORDED + 41 * SECOND) - START, 1000);
  }

  @Test
  void beforeTheBeginningItPassedAtItsOwnSpeed() {
    track.begin(START, RECORDED);
    play(START, RECORDED, 10, 1);
    assertEquals(RECORDED - 3 * SECOND, track.time(START - 3 * SECOND));
    assertEquals(START - 3 * SECOND, track.moment(RECORDED - 3 * SECOND));
  }

  @Test
  void afterTheLastMomentItStands() {
    track.begin(START, RECORDED);
    assertEquals(RECORDED, track.time(START + SECOND));
    assertEquals(START, track.moment(RECORDED + SECOND));
  }

  @Test
  void whatWasBeforeABeginningCountsNoMore() {
    track.begin(START, RECORDED);
    play(START, RECORDED, 100, 2);
    track.begin(START + 3 * SECOND, RECORDED + 1000 * SECOND);
    assertEquals(RECORDED + 999 * SECOND, track.time(START + 2 * SECOND));
  }

  @Test
  void moreThanIsKeptIsForgottenFromItsBeginning() {
    track.begin(START, RECORDED);
    play(START, RECORDED, 2, 1200);
    assertEquals(RECORDED + 2390 * SECOND, track.time(START + 1195 * SECOND), 1000);
    assertEquals(START + 1195 * SECOND - START, track.moment(RECORDED + 2390 * SECOND) - START, 1000);
    long oldest = track.time(START + 600 * SECOND);
    assertEquals(oldest - 100 * SECOND, track.time(START + 500 * SECOND), SECOND);
  }
}
