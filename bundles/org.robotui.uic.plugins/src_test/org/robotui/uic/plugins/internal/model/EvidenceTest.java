package org.robotui.uic.plugins.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.data.control.Histogram;
import org.robotui.uic.plugins.internal.Controls;

class EvidenceTest {
  private static final List<Long> LOWER = List.of(0L, 1000L, 2000L, 4000L, 8000L);

  private static Histogram histogram(long max, Long... counts) {
    return new Histogram(List.of(counts), LOWER, max);
  }

  @Test
  void threeFiguresTellAHistogram() {
    Evidence evidence = Evidence.of(histogram(9000, 0L, 90L, 9L, 0L, 1L), Optional.empty());
    assertEquals(2000, evidence.p50());
    assertEquals(4000, evidence.p99());
    assertEquals("9.00\u00a0\u00b5s", evidence.longest());
    assertEquals(0.9, evidence.share(10_000), 1e-9);
  }

  @Test
  void nothingIsADash() {
    Evidence evidence = Evidence.of(Controls.nothing(), Optional.empty());
    assertTrue(evidence.isEmpty());
    assertEquals("\u2014", evidence.longest());
    assertEquals("\u2014", Durations.of(evidence.p50()));
    assertTrue(Double.isNaN(evidence.share(0)));
  }

  @Test
  void afterAResetTheLongestIsThatOfItsBucket() {
    Histogram before = histogram(9000, 0L, 90L, 9L, 0L, 1L);
    Evidence evidence = Evidence.of(histogram(9000, 0L, 190L, 10L, 0L, 1L), Optional.of(before));
    assertEquals(101, evidence.histogram().count());
    assertEquals("\u2264\u00a04.00\u00a0\u00b5s", evidence.longest());
  }

  @Test
  void aNewRecordAfterAResetIsExact() {
    Histogram before = histogram(3000, 0L, 90L, 9L, 0L, 0L);
    Evidence evidence = Evidence.of(histogram(9500, 0L, 90L, 9L, 0L, 1L), Optional.of(before));
    assertFalse(evidence.bound());
    assertEquals(9500, evidence.max());
  }

  @Test
  void aProcessThatWasStartedAgainCountsFromZero() {
    Histogram before = histogram(9000, 0L, 90L, 9L, 0L, 1L);
    Evidence evidence = Evidence.of(histogram(1500, 0L, 7L, 0L, 0L, 0L), Optional.of(before));
    assertEquals(7, evidence.histogram().count());
    assertEquals(1500, evidence.max());
  }

  @Test
  void theAxisIsLogarithmicAndHoldsThePeriod() {
    HistogramShape shape = HistogramShape.of(histogram(9000, 0L, 90L, 9L, 0L, 1L), 100_000);
    assertEquals(1000, shape.from(), 1e-6);
    assertEquals(100_000, shape.to(), 1e-3);
    assertEquals(0.5, shape.share(10_000), 1e-9);
    assertEquals(3, shape.bars().size());
    assertEquals(1, shape.bars().getFirst().height(), 1e-9);
    assertEquals(Math.log(2) / Math.log(91), shape.bars().getLast().height(), 1e-9);
    assertEquals(3, shape.decades().length);
  }

  @Test
  void durationsHaveThreeDigits() {
    assertEquals("850\u00a0ns", Durations.of(850));
    assertEquals("4.20\u00a0\u00b5s", Durations.of(4200));
    assertEquals("88.0\u00a0\u00b5s", Durations.of(88_000));
    assertEquals("210\u00a0\u00b5s", Durations.of(210_000));
    assertEquals("11.7\u00a0ms", Durations.of(11_700_000));
    assertEquals("1.50\u00a0s", Durations.of(1.5e9));
    assertEquals("120\u2009431", Durations.count(120_431));
  }
}
