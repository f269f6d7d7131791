package org.robotui.workbench.internal.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.ZoneId;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TimeWordsTest {
  @Test
  void aTimeIsThatOfAPlace() {
    long time = 1_700_000_000_123_456_789L;
    assertEquals("2023-11-14 22:13:20.123", TimeWords.local(time, ZoneId.of("UTC")));
    assertEquals("2023-11-14 23:13:20.123", TimeWords.local(time, ZoneId.of("Europe/Berlin")));
    assertEquals("1969-12-31 23:59:59.999", TimeWords.local(-1_000_000, ZoneId.of("UTC")));
    assertEquals("12.346\u00a0s", TimeWords.seconds(12_345_678_901L));
  }

  @ParameterizedTest
  @CsvSource({"7500000000, 1, 7.5\u00a0s", "67500000000, 1, 1:07.5", "7267000000000, 0, 2:01:07", "0, 0, 0\u00a0s",
      "86400000000000, 0, 1\u00a0d", "187267000000000, 0, 2\u00a0d\u00a04:01:07",
      "-1500000000, 1, \u22121.5\u00a0s", "600000000000, 0, 10:00", "59999999999, 0, 59\u00a0s"})
  void aLengthOfTimeIsAsLongAsItMustBe(long nanos, int decimals, String words) {
    assertEquals(words, TimeWords.elapsed(nanos, decimals));
  }

  @ParameterizedTest
  @CsvSource({"0.01, 0.01\u00d7", "0.5, 0.5\u00d7", "1, 1\u00d7", "10, 10\u00d7", "100, 100\u00d7"})
  void aSpeedHasNoMoreDigitsThanItNeeds(double factor, String words) {
    assertEquals(words, TimeWords.speed(factor));
  }

  @Test
  void messagesAreCountedInWords() {
    assertEquals("0 messages", TimeWords.messages(0));
    assertEquals("1 message", TimeWords.messages(1));
    assertEquals("1\u202f234\u202f567 messages", TimeWords.messages(1_234_567));
  }

  @ParameterizedTest
  @CsvSource({"1.5, 1500000000", "-0.000000001, -1", "\u22122, -2000000000", "'0,25', 250000000",
      "1700000000.123456789, 1700000000123456789", "' 3 ', 3000000000", "+1, 1000000000"})
  void anOffsetIsReadToTheNanosecond(String written, long nanos) {
    assertEquals(Optional.of(nanos), TimeWords.nanos(written));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "x", "1e9", "NaN", "1.0000000001", "9999999999", "--1", "1 2"})
  void whatIsNoOffsetIsRefused(String written) {
    assertEquals(Optional.empty(), TimeWords.nanos(written));
  }

  @ParameterizedTest
  @ValueSource(longs = {0, 1, -1, 1_500_000_000L, -250_000_000L, 1_700_000_000_123_456_789L, 10_000_000_000L})
  void whatIsShownOfAnOffsetIsReadAsTheSame(long nanos) {
    assertEquals(Optional.of(nanos), TimeWords.nanos(TimeWords.offset(nanos)));
  }
}
