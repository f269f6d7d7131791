package org.robotui.uic.console.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class InputHistoryTest {
  @Test
  void goesBackAndForthAndKeepsWhatWasBegun() {
    InputHistory history = new InputHistory(List.of("one", "two"));
    assertEquals(Optional.of("two"), history.older("thr"));
    assertEquals(Optional.of("one"), history.older("two"));
    assertTrue(history.older("one").isEmpty());
    assertEquals(Optional.of("two"), history.newer());
    assertEquals(Optional.of("thr"), history.newer());
    assertTrue(history.newer().isEmpty());
  }

  @Test
  void whatIsRunAgainMovesToTheEnd() {
    InputHistory history = new InputHistory(List.of("one", "two"));
    history.older("");
    history.add("one");
    history.add(" ");
    assertEquals(List.of("two", "one"), history.all());
    assertEquals(Optional.of("one"), history.older(""));
  }

  @Test
  void isBounded() {
    InputHistory history = new InputHistory(List.of());
    IntStream.range(0, 250).forEach(i -> history.add("line " + i));
    history.add("x".repeat(10_000));
    assertEquals(InputHistory.MOST, history.all().size());
    assertEquals("line 249", history.all().getLast());
  }
}
