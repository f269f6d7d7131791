package org.robotui.uic.sound.internal;

import java.io.Console;
import java.util.Optional;

/** The bell of the terminal, where there is one. */
final class TerminalBell {
  private static final char BELL = 7;

  private TerminalBell() {}

  static void ring() {
    Optional.ofNullable(System.console()).map(Console::writer).ifPresent(writer -> {
      writer.print(BELL);
      writer.flush();
    });
  }
}
