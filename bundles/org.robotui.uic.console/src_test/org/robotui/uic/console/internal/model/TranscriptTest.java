package org.robotui.uic.console.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.uic.console.internal.model.ConsoleLine.Kind;

class TranscriptTest {
  private final Transcript transcript = new Transcript();

  @Test
  void givesWhatCameSince() {
    transcript.add(Kind.INPUT, "1 +\n1");
    transcript.add(Kind.VALUE, "2");
    Transcript.Part part = transcript.since(1);
    assertEquals(0, part.begin());
    assertEquals(2, part.end());
    assertEquals("2", part.lines().getFirst().shown());
    assertEquals("> 1 +\n  1", transcript.since(0).lines().getFirst().shown());
    assertTrue(transcript.since(2).lines().isEmpty());
  }

  @Test
  void theOldestGoes() {
    for (int i = 0; i < 3 * Transcript.MOST_LINES; i++) {
      transcript.add(Kind.OUTPUT, "line " + i);
    }
    Transcript.Part part = transcript.since(0);
    assertEquals(Transcript.MOST_LINES, part.lines().size());
    assertEquals(2L * Transcript.MOST_LINES, part.begin());
    assertEquals("line " + (3 * Transcript.MOST_LINES - 1), part.lines().getLast().text());
  }

  @Test
  void hugeTextsAreCutAndSaid() {
    for (int i = 0; i < 100; i++) {
      transcript.add(Kind.OUTPUT, "x".repeat(1_000_000));
    }
    Transcript.Part part = transcript.since(0);
    assertTrue(part.lines().stream().mapToInt(line -> line.text().length()).sum() <= 400_000);
    assertTrue(part.lines().getFirst().text().endsWith("(980000 more characters)"));
  }

  @Test
  void whatIsClearedIsGone() {
    transcript.add(Kind.OUTPUT, "a");
    transcript.clear();
    transcript.add(Kind.OUTPUT, "b");
    Transcript.Part part = transcript.since(0);
    assertEquals(1, part.begin());
    assertEquals(1, part.lines().size());
  }
}
