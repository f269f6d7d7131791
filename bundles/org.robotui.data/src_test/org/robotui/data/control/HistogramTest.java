package org.robotui.data.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class HistogramTest {
  private static final List<Long> LOWER = List.of(0L, 100L, 200L, 400L);

  private static Histogram of(long max, Long... counts) {
    return new Histogram(List.of(counts), LOWER, max);
  }

  @Test
  void percentilesAreTheEndsOfTheirBuckets() {
    Histogram histogram = of(900, 90L, 9L, 0L, 1L);
    assertEquals(100, histogram.percentile(0.5));
    assertEquals(200, histogram.percentile(0.99));
    assertEquals(900, histogram.percentile(1));
    assertEquals(100, histogram.count());
  }

  @Test
  void noPercentileIsLongerThanTheLongest() {
    assertEquals(130, of(130, 0L, 5L, 0L, 0L).percentile(0.99));
  }

  @Test
  void whereNothingWasThereIsNoPercentile() {
    assertTrue(Double.isNaN(of(0, 0L, 0L, 0L, 0L).percentile(0.99)));
  }

  @Test
  void whatCameSinceIsTheDifference() {
    assertEquals(List.of(1L, 0L, 2L, 0L), of(300, 4L, 1L, 2L, 0L).since(of(150, 3L, 1L, 0L, 0L)).counts());
  }

  @Test
  void afterARestartAllIsNew() {
    assertEquals(List.of(1L, 1L, 0L, 0L), of(150, 1L, 1L, 0L, 0L).since(of(150, 0L, 0L, 7L, 0L)).counts());
  }

  @Test
  void everyBucketHasItsLowerEnd() {
    assertThrows(IllegalArgumentException.class, () -> new Histogram(List.of(1L), LOWER, 1));
  }
}
