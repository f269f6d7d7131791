package org.robotui.workbench.internal.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class LatenciesTest {
  private static final long MILLISECOND = 1_000_000;

  private final Latencies latencies = new Latencies();

  @Test
  void withoutAnyThereIsNothingToTell() {
    assertEquals(0, latencies.count());
    assertEquals(0, latencies.percentile(0.99));
  }

  @Test
  void percentilesAreRightWithinTwoPercent() {
    for (int i = 1; i <= 1000; i++) {
      latencies.add(i * MILLISECOND);
    }
    assertEquals(1000, latencies.count());
    assertEquals(500, latencies.percentile(0.5), 500 * 0.03);
    assertEquals(990, latencies.percentile(0.99), 990 * 0.03);
    assertEquals(1000, latencies.percentile(1), 1000 * 0.03);
  }

  @Test
  void extremesStayWithinTheClasses() {
    latencies.add(0);
    latencies.add(Long.MAX_VALUE);
    assertEquals(2, latencies.count());
  }
}
