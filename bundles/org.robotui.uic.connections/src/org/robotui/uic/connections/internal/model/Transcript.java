package org.robotui.uic.connections.internal.model;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Lines as text, for a report of a fault: a line each, indented, with all that the view has of it. */
public final class Transcript {
  private static final int WORD = 12;

  private Transcript() {}

  /** The whole list below its summary. */
  public static String of(String summary, List<ConnectionLine> lines) {
    return summary + "\n" + lines.stream().map(Transcript::of).collect(Collectors.joining());
  }

  private static String of(ConnectionLine line) {
    String facts = Stream
        .of(line.since(), line.age().isEmpty() ? "" : "newest " + line.age() + " old", line.dropped(), line.text())
        .filter(fact -> !fact.isEmpty()).collect(Collectors.joining(", "));
    return ("  ".repeat(line.level()) + mark(line) + " " + padded(line.word()) + " " + line.name()
        + (facts.isEmpty() ? "" : ": " + facts))
        .replace('\n', ' ').stripTrailing() + "\n";
  }

  private static String mark(ConnectionLine line) {
    return line.isProblem() ? "!" : " ";
  }

  private static String padded(String word) {
    return word + " ".repeat(Math.max(0, WORD - word.length()));
  }
}
