package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class ClosingTimeTest {
  private static final Duration SHORT = Duration.ofMillis(1200);

  private static Duration millis(long millis) {
    return Duration.ofMillis(millis);
  }

  @Test
  void ofFewIsWhatItShallBeAndComponentsHaveWhatCoreDoesNotNeed() {
    assertEquals(new ClosingTime(SHORT, millis(700)), ClosingTime.of(SHORT, 10));
    assertEquals(new ClosingTime(millis(1800), millis(1100)), ClosingTime.of(millis(1800), 0));
    assertEquals(new ClosingTime(millis(10_000), millis(2000)), ClosingTime.of(millis(10_000), 3));
  }

  @Test
  void eachOfManyGivesAllMoreTime() {
    assertEquals(new ClosingTime(millis(2400), millis(1900)), ClosingTime.of(SHORT, 50));
  }
}
