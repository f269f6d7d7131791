package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.headless.internal.Terminal.Size;

class TerminalTest {
  @Test
  void readsWhatSttySays() {
    assertEquals(Optional.of(new Size(120, 40)), Terminal.parse("40 120\n"));
  }

  @Test
  void aSizeThatCannotBeIsNone() {
    assertEquals(Optional.empty(), Terminal.parse("0 0\n"));
    assertEquals(Optional.empty(), Terminal.parse(""));
    assertEquals(Optional.empty(), Terminal.parse("forty 2"));
  }
}
