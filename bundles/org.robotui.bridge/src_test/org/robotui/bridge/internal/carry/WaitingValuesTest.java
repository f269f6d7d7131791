package org.robotui.bridge.internal.carry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.robotui.api.bridge.BridgeWords;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.MapRecord;
import org.robotui.testkit.FakeSettings;

/** Time is a number here. */
class WaitingValuesTest {
  private static final long SECOND = 1_000_000_000L;

  private static WaitingValues waiting(Map<String, Object> settings) {
    FakeSettings values = new FakeSettings(BridgeWords.SCHEMA);
    settings.forEach(values::set);
    return new WaitingValues(values.current());
  }

  private static void add(WaitingValues waiting, long first, long last) {
    LongStream.rangeClosed(first, last).forEach(number -> waiting.add(new Envelope<>(
        new MapRecord("demo/Note", Map.of()), new SourceId("base", "said"), number, Optional.empty(), 0,
        Optional.empty())));
  }

  private static List<Long> passed(WaitingValues waiting, long now) {
    List<Long> all = new ArrayList<>();
    Optional<Envelope<?>> next = waiting.next(now);
    while (next.isPresent()) {
      all.add(next.get().sequence());
      waiting.passed(now);
      next = waiting.next(now);
    }
    return all;
  }

  @Test
  void ofValuesThatAreConflatedTheNewestPassesAndTheOthersAreCounted() {
    WaitingValues waiting = waiting(Map.of("keep", "newest"));
    add(waiting, 0, 9);
    assertEquals(List.of(9L), passed(waiting, 0));
    assertEquals(9, waiting.thinned());
    assertEquals(0, waiting.dropped());
  }

  @Test
  void aRateConflatesBetweenTwoValuesThatPass() {
    WaitingValues waiting = waiting(Map.of("rate", 1.0));
    add(waiting, 0, 2);
    assertEquals(List.of(2L), passed(waiting, 0));
    add(waiting, 3, 5);
    assertEquals(List.of(), passed(waiting, SECOND / 2));
    assertEquals(List.of(5L), passed(waiting, SECOND));
    assertEquals(4, waiting.thinned());
    assertTrue(waiting.isEmpty());
  }

  @Test
  void aRateThatKeepsAllDelaysThemInOrder() {
    WaitingValues waiting = waiting(Map.of("rate", 1.0, "keep", "all"));
    add(waiting, 0, 2);
    assertEquals(List.of(0L), passed(waiting, 0));
    assertEquals(List.of(1L), passed(waiting, SECOND));
    assertEquals(List.of(2L), passed(waiting, 2 * SECOND));
    assertEquals(0, waiting.thinned() + waiting.dropped());
  }

  @Test
  void aFullQueueDropsTheOldestAndCountsThem() {
    WaitingValues waiting = waiting(Map.of("queue", 3L));
    add(waiting, 0, 9);
    assertEquals(List.of(7L, 8L, 9L), passed(waiting, 0));
    assertEquals(7, waiting.dropped());
  }
}
