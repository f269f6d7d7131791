package org.robotui.ros.internal.tcpros;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class ReadPacingTest {

  private final ReadPacing pacing = new ReadPacing();
  private long nanos = 1_000_000_000;

  @Test
  void aFloodOfSmallMessagesIsGathered() {
    send(10_000, 100, 3_000);
    assertEquals(true, pacing.isFlood());
  }

  @Test
  void anOrdinaryRateIsReadAtOnce() {
    send(2_000, 100, 1_000_000);
    assertEquals(false, pacing.isFlood());
  }

  @Test
  void aBurstOfTransformsEveryTenthOfASecondIsReadAtOnce() {
    for (int burst = 0; burst < 20; burst++) {
      send(30, 100, 5_000);
      assertEquals(false, pacing.isFlood(), "burst " + burst);
      nanos += 100_000_000;
    }
  }

  @Test
  void largeMessagesAreReadAtOnce() {
    send(10_000, 100_000, 20_000);
    assertEquals(false, pacing.isFlood());
  }

  @Test
  void whatBecomesSlowAgainIsReadAtOnceAgain() {
    send(10_000, 100, 3_000);
    send(2, 100, 2_000_000);
    assertEquals(false, pacing.isFlood());
  }

  private void send(int count, int bytes, long pauseNanos) {
    for (int i = 0; i < count; i++) {
      nanos += pauseNanos;
      pacing.count(bytes, nanos);
    }
  }
}
