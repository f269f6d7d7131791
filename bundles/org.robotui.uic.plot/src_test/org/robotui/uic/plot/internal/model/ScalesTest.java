package org.robotui.uic.plot.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.uic.plot.internal.trace.Summary;
import org.robotui.uic.plot.internal.trace.TimeSpan;

class ScalesTest {
  private static final long SECOND = TimeSpan.SECOND;
  private static final long NOON = 1_700_049_600L * SECOND;

  @Test
  void scalesAreBoundedWhateverTheNumbersAre() {
    double[] values = {-Double.MAX_VALUE, -1e300, -1, -Double.MIN_VALUE, 0, Double.MIN_VALUE, 1e-300, 1, 1e9, 1e300,
        Double.MAX_VALUE};
    for (double low : values) {
      for (double high : values) {
        if (low <= high) {
          Summary seen = new Summary();
          seen.add(low);
          seen.add(high);
          ValueSpan span = AutoRange.next(seen, Optional.empty(), false);
          assertTrue(Ticks.of(span.low(), span.high(), 10).count() <= 11, low + " to " + high);
        }
      }
    }
  }

  @Test
  void timesAreBoundedWhateverTheStampsAre() {
    long[] times = {Long.MIN_VALUE, Long.MIN_VALUE + 1, -SECOND, 0, 1, NOON, Long.MAX_VALUE - 1, Long.MAX_VALUE};
    for (long from : times) {
      for (long to : times) {
        for (int most : new int[]{1, 7}) {
          if (from <= to) {
            assertTrue(TimeTicks.relative(new TimeSpan(from, to), most).size() <= most + 2);
            assertTrue(TimeTicks.absolute(new TimeSpan(from, to), most, ZoneOffset.UTC).size() <= most + 2);
          }
        }
      }
    }
  }

  @Test
  void ticksAreRoundAndAsManyAsFit() {
    assertEquals(List.of("\u22120.5", "0.0", "0.5", "1.0"), labels(Ticks.of(-0.7, 1.1, 5)));
    assertEquals(List.of("0", "50", "100"), labels(Ticks.of(0, 100, 4)));
    assertEquals(List.of("0.001", "0.002", "0.003"), labels(Ticks.of(0.0009, 0.0031, 4)));
  }

  @Test
  void hugeAndTinyValuesAreWrittenWithAPowerOfTen() {
    assertEquals(List.of("0", "1e9", "2e9"), labels(Ticks.of(0, 2e9, 4)));
    assertEquals("1.0002e8", Ticks.of(1.0001e8, 1.0003e8, 3).label(1));
  }

  @Test
  void anyTicksLieWithinDifferAndAreFew() {
    Random random = new Random(2);
    for (int i = 0; i < 3000; i++) {
      double low = random.nextGaussian() * Math.pow(10, random.nextInt(12) - 6);
      double high =
          low + Math.abs(random.nextGaussian() + 0.01) * Math.pow(10, random.nextInt(8) - 4) + Math.abs(low) * 1e-6;
      int most = 2 + random.nextInt(12);
      Ticks ticks = Ticks.of(low, high, most);
      List<String> labels = labels(ticks);
      assertTrue(labels.size() <= most + 1, low + ".." + high + " " + labels);
      assertEquals(labels.size(), labels.stream().distinct().count(), low + ".." + high + " " + labels);
      for (int t = 0; t < ticks.count(); t++) {
        assertTrue(ticks.at(t) >= low - ticks.step() * 1e-6 && ticks.at(t) <= high + ticks.step() * 1e-6);
      }
    }
  }

  @Test
  void liveTimesAreCountedBackFromNow() {
    assertEquals(List.of("\u221260\u00a0s", "\u221245\u00a0s", "\u221230\u00a0s", "\u221215\u00a0s", "now"),
        relative(60, 5));
    assertEquals(List.of("\u22121.0\u00a0s", "\u22120.5\u00a0s", "now"), relative(1, 2));
    assertEquals(List.of("\u221210\u00a0min", "\u22125\u00a0min", "now"), relative(600, 3));
    assertEquals("\u22122\u00a0h", relative(7200, 3).getFirst());
  }

  @Test
  void heldTimesAreThoseOfTheClockOfTheUser() {
    assertEquals(List.of("12:00:00", "12:00:05", "12:00:10"), absolute(NOON, 10, 3, ZoneOffset.UTC));
    assertEquals(List.of("12:00:00.0", "12:00:00.5", "12:00:01.0"), absolute(NOON, 1, 3, ZoneOffset.UTC));
    assertEquals("17:30", absolute(NOON, 3600, 3, ZoneId.of("Asia/Kolkata")).getFirst());
  }

  @Test
  void simulatedTimesAreSecondsFromTheBeginning() {
    assertEquals(List.of("100\u00a0s", "105\u00a0s", "110\u00a0s"), absolute(100 * SECOND, 10, 3, ZoneOffset.UTC));
  }

  @Test
  void timesAreNeverMoreThanFitAndNeverEqual() {
    for (double seconds = 1e-5; seconds < 1e8; seconds *= 1.37) {
      for (int most : new int[]{1, 3, 8}) {
        TimeSpan span = TimeSpan.until(NOON, seconds);
        List<TimeTicks.Tick> ticks = TimeTicks.relative(span, most);
        assertTrue(ticks.size() <= most + 1, seconds + " s: " + ticks);
        assertEquals(ticks.size(), ticks.stream().map(TimeTicks.Tick::label).distinct().count(),
            seconds + " s: " + ticks);
        assertTrue(TimeTicks.absolute(span, most, ZoneOffset.UTC).size() <= most + 1);
      }
    }
  }

  @Test
  void theRangeHasRoomAroundWhatIsSeen() {
    ValueSpan range = AutoRange.next(seen(-0.42, 0.37), Optional.empty(), false);
    assertTrue(range.low() < -0.42 && range.high() > 0.37 && range.length() < 1.2, range.toString());
    ValueSpan flat = AutoRange.next(seen(5, 5), Optional.empty(), false);
    assertTrue(flat.low() < 5 && flat.high() > 5);
    assertEquals(new ValueSpan(-1, 1), AutoRange.next(new Summary(), Optional.empty(), false));
  }

  @Test
  void theRangeStaysWhileItFitsAndShrinksWhereItIsMuchTooLarge() {
    ValueSpan range = AutoRange.next(seen(-1, 1), Optional.empty(), false);
    assertEquals(range, AutoRange.next(seen(-0.9, 0.95), Optional.of(range), false));
    assertTrue(AutoRange.next(seen(-0.1, 0.1), Optional.of(range), false).length() < range.length() / 3);
    assertTrue(AutoRange.next(seen(-3, 1), Optional.of(range), false).low() < -3);
  }

  @Test
  void aHeldRangeGrowsAndNeverShrinks() {
    ValueSpan range = AutoRange.next(seen(-1, 1), Optional.empty(), true);
    assertEquals(range, AutoRange.next(seen(0, 0.001), Optional.of(range), true));
    ValueSpan more = AutoRange.next(seen(0, 7), Optional.of(range), true);
    assertEquals(range.low(), more.low());
    assertTrue(more.high() > 7);
  }

  @Test
  void anyValuesMakeARange() {
    Random random = new Random(4);
    for (int i = 0; i < 3000; i++) {
      double low = random.nextGaussian() * Math.pow(10, random.nextInt(300) - 150);
      double high = low + Math.abs(random.nextGaussian()) * Math.pow(10, random.nextInt(300) - 150);
      ValueSpan range = AutoRange.next(seen(low, high), Optional.empty(), false);
      assertTrue(range.low() <= low && range.high() >= high, low + ".." + high + " " + range);
    }
    AutoRange.next(seen(-Double.MAX_VALUE, Double.MAX_VALUE), Optional.empty(), false);
  }

  @Test
  void zoomingInEndsWhereNumbersEnd() {
    ValueSpan range = new ValueSpan(1e9, 1e9 + 1);
    for (int i = 0; i < 1000; i++) {
      range = range.zoomed(0.5, 1e9 + 0.3);
    }
    assertTrue(range.length() > 0);
    for (int i = 0; i < 5000; i++) {
      range = range.zoomed(2, 0);
    }
    assertTrue(Double.isFinite(range.length()));
  }

  @Test
  void liveTimeGoesOnAndHeldTimeStays() {
    TimeSpan span = TimeView.LIVE.span(NOON, 10, Optional.empty());
    assertEquals(new TimeSpan(NOON - 10 * SECOND, NOON), span);
    TimeView held = TimeView.LIVE.hold(span);
    assertEquals(span, held.span(NOON + 99 * SECOND, 10, Optional.empty()));
    assertEquals(span.moved(-SECOND), held.moved(span, -SECOND).span(NOON, 10, Optional.empty()));
  }

  @Test
  void zoomingLiveKeepsNowZoomingHeldKeepsThePointer() {
    TimeSpan span = TimeView.LIVE.span(NOON, 10, Optional.empty());
    TimeSpan live = TimeView.LIVE.zoomed(span, 0.5, span.from()).span(NOON, 10, Optional.empty());
    assertEquals(new TimeSpan(NOON - 5 * SECOND, NOON), live);
    TimeSpan held =
        TimeView.LIVE.hold(span).zoomed(span, 0.5, span.from() + 2 * SECOND).span(NOON, 10, Optional.empty());
    assertEquals(new TimeSpan(span.from() + SECOND, span.from() + 6 * SECOND), held);
  }

  @Test
  void allTimeReachesFromTheFirstSampleToNow() {
    TimeSpan all = new TimeSpan(NOON - 500 * SECOND, NOON - SECOND);
    assertEquals(new TimeSpan(all.from(), NOON), TimeView.LIVE.span(NOON, 0, Optional.of(all)));
    assertEquals(SECOND, TimeView.LIVE.span(NOON, 0, Optional.empty()).length());
  }

  @Test
  void zoomedTimeNeverVanishesOrOverflows() {
    TimeSpan span = TimeSpan.until(NOON, 10);
    for (int i = 0; i < 500; i++) {
      span = span.zoomed(0.8, span.from() + span.length() / 2);
    }
    assertTrue(span.length() > 0);
    for (int i = 0; i < 500; i++) {
      span = span.zoomed(1.3, span.from());
    }
    assertTrue(span.length() > 0 && span.seconds() < 1e9);
  }

  @Test
  void cursorsSayHowFarApartTheyAre() {
    assertEquals("\u0394t 0.420\u00a0s \u00b7 1/\u0394t 2.381\u00a0Hz", new CursorPair(0, 420_000_000L).text());
    assertEquals("\u0394t \u22125.000\u00a0ms \u00b7 1/\u0394t 200.0\u00a0Hz", new CursorPair(5_000_000L, 0).text());
    assertEquals("\u0394t 0.000\u00a0ms", new CursorPair(7, 7).text());
  }

  @Test
  void readoutsHaveAboutFourDigits() {
    assertEquals("0.310\u00a0m/s", Readout.of(0.31, "m/s"));
    assertEquals("\u221212.35", Readout.of(-12.3456));
    assertEquals("1235", Readout.of(1234.56));
    assertEquals("1.235e9", Readout.of(1.23456e9));
    assertEquals("1.000e\u22127", Readout.of(1e-7));
    assertEquals("0.000", Readout.of(0));
    assertEquals("\u2014", Readout.of(Double.NaN));
  }

  private static List<String> labels(Ticks ticks) {
    return IntStream.range(0, ticks.count()).mapToObj(ticks::label).toList();
  }

  private static List<String> relative(double seconds, int most) {
    return TimeTicks.relative(TimeSpan.until(NOON, seconds), most).stream().map(TimeTicks.Tick::label).toList();
  }

  private static List<String> absolute(long from, double seconds, int most, ZoneId zone) {
    return TimeTicks.absolute(new TimeSpan(from, from + TimeSpan.nanos(seconds)), most, zone).stream()
        .map(TimeTicks.Tick::label).toList();
  }

  private static Summary seen(double low, double high) {
    Summary summary = new Summary();
    summary.add(low);
    summary.add(high);
    return summary;
  }
}
