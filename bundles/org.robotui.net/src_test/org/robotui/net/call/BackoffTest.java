package org.robotui.net.call;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class BackoffTest {

  @Test
  void pausesGrowUpToTheirBoundWithJitter() {
    Backoff backoff = new Backoff(Duration.ofMillis(100), Duration.ofMillis(1000));
    List<Long> pauses = Stream.generate(backoff::next).limit(10).map(Duration::toMillis).toList();
    assertTrue(pauses.getFirst() >= 75 && pauses.getFirst() <= 125, pauses.toString());
    assertTrue(pauses.getLast() >= 750 && pauses.getLast() <= 1000, pauses.toString());
    backoff.reset();
    assertTrue(backoff.next().toMillis() <= 125);
  }
}
