package org.robotui.uic.plot.internal.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SeriesTest {
  private static final int MANY = 30_000;

  private final List<Sample> all = new ArrayList<>();

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void summariesOfAnySpanAreThoseOfAllItsSamples(long seed) {
    Random random = new Random(seed);
    Series series = filled(random, MANY);
    Summary fast = new Summary();
    for (int i = 0; i < 400; i++) {
      TimeSpan span = anySpan(random);
      fast.clear();
      series.summarize(span, fast);
      Summary slow = slow(span);
      assertEquals(slow.count(), fast.count(), span.toString());
      assertEquals(slow.min(), fast.min(), span.toString());
      assertEquals(slow.max(), fast.max(), span.toString());
      assertEquals(slow.mean(), fast.mean(), 1e-9, span.toString());
      assertEquals(slow.deviation(), fast.deviation(), 1e-9, span.toString());
    }
  }

  @Test
  void statisticsAreOfFiniteSamplesInASpan() {
    Series series = new Series(10);
    double[] values = {9, 2, Double.NaN, 4, 4, Double.POSITIVE_INFINITY, 4, 5, 5, 7, 9, 1};
    for (int i = 0; i < values.length; i++) {
      series.add(i * TimeSpan.SECOND / 2, values[i]);
    }
    Statistics all = series.statistics(new TimeSpan(TimeSpan.SECOND / 2, 5 * TimeSpan.SECOND));
    assertEquals(new Statistics(8, 2, 9, 5, 2, 7 / 4.5), all);
    assertEquals(new Statistics(1, 9, 9, 9, 0, Double.NaN), series.statistics(new TimeSpan(0, 1)));
    assertEquals(new Statistics(0, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN),
        series.statistics(new TimeSpan(-9, -1)));
    assertEquals(0, new Series(10).statistics(new TimeSpan(0, 1)).count());
  }

  @Test
  void deviationsOfLargeNumbersAreExact() {
    Series series = new Series(100_000);
    for (int i = 0; i < 100_000; i++) {
      series.add(i, 1.7e9 + (i % 2 == 0 ? 0.001 : -0.001));
    }
    assertEquals(0.001, series.statistics(new TimeSpan(0, 100_000)).deviation(), 1e-6);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 7, 300, 1500})
  void aSketchShowsTheExtremesOfEveryColumn(int columns) {
    Random random = new Random(columns);
    Series series = filled(random, MANY);
    Sketch sketch = new Sketch();
    for (int i = 0; i < 60; i++) {
      TimeSpan span = anySpan(random);
      series.sketch(span, columns, sketch);
      assertColumns(span, columns, sketch);
    }
  }

  @Test
  void aSketchIsAsLargeAsTheScreenNotAsTheSeries() {
    Series series = filled(new Random(9), MANY);
    Sketch sketch = new Sketch();
    series.sketch(new TimeSpan(0, all.getLast().time()), 200, sketch);
    assertTrue(sketch.isDense());
    assertTrue(sketch.size() <= 4 * 202, "points: " + sketch.size());
  }

  @Test
  void fewSamplesAreSketchedAsTheyAreWithOneBeyondEachEnd() {
    Series series = new Series(1000);
    for (int i = 0; i < 10; i++) {
      series.add(i * 10L, i);
    }
    Sketch sketch = new Sketch();
    series.sketch(new TimeSpan(25, 65), 100, sketch);
    assertEquals(6, sketch.size());
    assertEquals(20, sketch.time(0));
    assertEquals(70, sketch.time(5));
  }

  @Test
  void columnsDoNotMoveWhenTheSpanDoes() {
    Series series = filled(new Random(4), MANY);
    long length = all.getLast().time() / 2;
    Sketch one = new Sketch();
    Sketch other = new Sketch();
    series.sketch(new TimeSpan(1000, 1000 + length), 100, one);
    series.sketch(new TimeSpan(1234, 1234 + length), 100, other);
    List<Long> middles = new ArrayList<>();
    for (int i = 0; i < other.size(); i++) {
      middles.add(other.time(i));
    }
    int found = 0;
    for (int i = 10; i < one.size() - 10; i++) {
      found += middles.contains(one.time(i)) ? 1 : 0;
    }
    assertEquals(one.size() - 20, found);
  }

  @Test
  void theOldestAreForgottenWhenMemoryIsFull() {
    Series series = new Series(Chunk.SIZE);
    for (int i = 0; i < 10 * Chunk.SIZE; i++) {
      series.add(i, i);
    }
    assertTrue(series.size() >= Chunk.SIZE && series.size() <= 2 * Chunk.SIZE, "kept " + series.size());
    assertEquals(10L * Chunk.SIZE - 1, series.extent().orElseThrow().to());
    assertEquals(Optional.of(new Sample(10L * Chunk.SIZE - 1, 10 * Chunk.SIZE - 1)), series.newest());
  }

  @Test
  void breaksAreNeitherNearestNorNewestNorCounted() {
    Series series = new Series(10);
    series.add(10, 1);
    series.add(20, Double.NaN);
    series.add(30, 3);
    series.add(40, Double.NEGATIVE_INFINITY);
    assertEquals(Optional.of(new Sample(30, 3)), series.newest());
    assertEquals(Optional.of(new Sample(10, 1)), series.nearest(19, 10));
    assertEquals(Optional.of(new Sample(30, 3)), series.nearest(21, 10));
    assertEquals(Optional.empty(), series.nearest(60, 10));
    Summary summary = new Summary();
    series.summarize(new TimeSpan(0, 100), summary);
    assertEquals(2, summary.count());
    assertEquals(1, summary.min());
  }

  @Test
  void samplesOnceTakenStayWhileTheSeriesGoesOn() {
    Series series = new Series(10);
    series.add(1, 1);
    Samples samples = series.samples();
    series.add(2, 2);
    series.clear();
    assertEquals(1, samples.size());
    assertEquals(1, samples.value(0));
    assertEquals(0, series.size());
  }

  @Test
  void timeNeverFallsWithinASeries() {
    Series series = new Series(10);
    series.add(5, 1);
    series.add(5, 2);
    assertThrows(IllegalArgumentException.class, () -> series.add(4, 3));
  }

  @Test
  void anEmptySeriesHasNothing() {
    Series series = new Series(10);
    Sketch sketch = new Sketch();
    series.sketch(new TimeSpan(0, 10), 10, sketch);
    assertEquals(0, sketch.size());
    assertEquals(Optional.empty(), series.extent());
    assertEquals(Optional.empty(), series.nearest(0, 100));
  }

  private Series filled(Random random, int count) {
    Series series = new Series(count);
    long time = 0;
    for (int i = 0; i < count; i++) {
      time += random.nextInt(100) == 0 ? 50_000 : random.nextInt(20);
      double value = random.nextInt(50) == 0 ? Double.NaN : random.nextGaussian() * (1 + i % 977);
      series.add(time, value);
      all.add(new Sample(time, value));
    }
    return series;
  }

  private TimeSpan anySpan(Random random) {
    long end = all.getLast().time();
    long from = random.nextLong(end) - 100;
    return new TimeSpan(from, from + random.nextLong(end));
  }

  private Summary slow(TimeSpan span) {
    Summary summary = new Summary();
    all.stream().filter(s -> span.contains(s.time())).forEach(s -> summary.add(s.value()));
    return summary;
  }

  /** Between two points of the sketch one column apart lies every sample that is there. */
  private void assertColumns(TimeSpan span, int columns, Sketch sketch) {
    long width = Math.max(1, Math.ceilDiv(span.length(), (long) columns));
    int point = 0;
    int sample = 0;
    while (point < sketch.size()) {
      long column = Math.floorDiv(sketch.time(point), width);
      Summary sketched = new Summary();
      for (; point < sketch.size() && Math.floorDiv(sketch.time(point), width) == column; point++) {
        sketched.add(sketch.value(point));
      }
      Summary real = new Summary();
      for (; sample < all.size() && Math.floorDiv(all.get(sample).time(), width) <= column; sample++) {
        if (Math.floorDiv(all.get(sample).time(), width) == column
            && (sketch.isDense() || span.contains(all.get(sample).time()))) {
          real.add(all.get(sample).value());
        }
      }
      boolean inner = column * width > span.from() && (column + 1) * width < span.to();
      if (inner) {
        assertEquals(real.min(), sketched.min(), "column " + column + " of " + span);
        assertEquals(real.max(), sketched.max(), "column " + column + " of " + span);
      }
    }
  }
}
