package org.robotui.rfic.player.internal.device;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RhythmTest {
  private static final long MS = 1_000_000L;

  private final Rhythm rhythm = new Rhythm();
  private long now = -17;

  private void come(int times, long everyMillis) {
    for (int i = 0; i < times; i++) {
      now += everyMillis * MS;
      rhythm.heard(now);
    }
  }

  private boolean silentAfter(long millis) {
    now += millis * MS;
    return rhythm.isSilent(now);
  }

  @Test
  void whatCameRegularlyIsSilentAfterFiveSeconds() {
    come(30, 100);
    assertFalse(silentAfter(4900));
    assertTrue(silentAfter(200));
  }

  @Test
  void whatComesOnChangeIsNeverSilent() {
    for (int i = 0; i < 20; i++) {
      come(3, 200);
      come(1, 3000);
    }
    assertFalse(silentAfter(60_000));
  }

  @Test
  void whatCameSeldomOrAFewTimesHasNoRhythm() {
    come(10, 100);
    assertFalse(silentAfter(60_000));
    rhythm.forget();
    come(30, 2000);
    assertFalse(silentAfter(60_000));
  }

  @Test
  void retriesComeMoreAndMoreSeldomUntilDataCome() {
    come(30, 100);
    assertTrue(silentAfter(5100));
    rhythm.retried(now);
    assertFalse(silentAfter(9900));
    assertTrue(silentAfter(200));
    rhythm.retried(now);
    assertFalse(silentAfter(19_900));
    come(1, 0);
    assertTrue(silentAfter(5100));
  }

  @Test
  void aLostLinkBeginsAnew() {
    come(30, 100);
    rhythm.forget();
    assertFalse(silentAfter(60_000));
  }
}
