package org.robotui.api.time;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class RateMeterTest {
  private static final long MILLI = 1_000_000;
  private static final long START = 5_000_000_000_000L;

  private static RateMeter after(int count, long periodNanos) {
    RateMeter meter = new RateMeter(START);
    for (int i = 1; i <= count; i++) {
      meter.mark(START + i * periodNanos);
    }
    return meter;
  }

  @Test
  void nothingHasNoRate() {
    RateMeter meter = new RateMeter(START);
    assertEquals(0, meter.rateHz(START));
    assertEquals(0, meter.rateHz(START + 100_000 * MILLI));
    assertEquals(0, meter.typicalPeriodSeconds());
    assertEquals(0, after(1, MILLI).rateHz(START + 2 * MILLI), "one value has no rate yet");
  }

  @Test
  void steadyStreamsAreMeasured() {
    assertEquals(10, after(100, 100 * MILLI).rateHz(START + 10_000 * MILLI), 0.5);
    assertEquals(1000, after(10_000, MILLI).rateHz(START + 10_000 * MILLI), 30);
    assertEquals(100, after(100, 10 * MILLI).rateHz(START + 1000 * MILLI), 15, "after one second");
  }

  @Test
  void slowStreamsAreMeasuredByTheirPeriod() {
    assertEquals(1, after(10, 1000 * MILLI).rateHz(START + 10_000 * MILLI), 0.05);
    assertEquals(0.1, after(10, 10_000 * MILLI).rateHz(START + 100_000 * MILLI), 0.005);
  }

  @Test
  void burstsAreAveraged() {
    RateMeter meter = new RateMeter(START);
    for (int burst = 0; burst < 50; burst++) {
      for (int i = 0; i < 10; i++) {
        meter.mark(START + burst * 100 * MILLI);
      }
    }
    assertEquals(100, meter.rateHz(START + 5000 * MILLI), 5);
  }

  @Test
  void streamThatEndedHasNoRate() {
    assertEquals(0, after(100, 100 * MILLI).rateHz(START + 20_000 * MILLI));
  }

  @Test
  void typicalPeriodIsNotMovedByOneGap() {
    RateMeter meter = after(15, 100 * MILLI);
    meter.mark(START + 15 * 100 * MILLI + 5000 * MILLI);
    assertEquals(0.1, meter.typicalPeriodSeconds(), 1e-6);
  }
}
