package org.robotui.uic.log.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.ZoneOffset;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.data.status.Severity;

class WordingTest {
  private final Wording wording = new Wording(ZoneOffset.UTC);

  private static Entry entry(long nanos, String message) {
    return new Entry(0, Severity.WARNING, "/motor", message, "motor.cpp:3", nanos, 0);
  }

  @Test
  void timesAreOfTheDayOrOfASimulatorsClock() {
    assertEquals("03:04:05.250", wording.time(entry(Log.START + 250_000_000, "")));
    assertEquals("2026-01-02 03:04:05.250", wording.date(entry(Log.START + 250_000_000, "")));
    assertEquals("12.500 s", wording.time(entry(12_500_000_000L, "")));
  }

  @Test
  void aLineAsTextHasEverythingAndAsManyLinesAsTheMessage() {
    assertEquals("2026-01-02 03:04:05.000  WARN   [/motor]  hot\n    very hot  (motor.cpp:3)",
        wording.text(LogLine.of(entry(Log.START, "hot\nvery hot\n"))));
    assertEquals("2026-01-02 03:04:05.000  WARN   [/motor]  hot  (motor.cpp:3) (2 times since 2026-01-02 03:04:04.000)",
        wording.text(LogLine.of(entry(Log.START - Log.SECOND, "hot")).and(entry(Log.START, "hot"))));
  }

  @Test
  void theFirstLineIsCutAndTellsThatThereIsMore() {
    assertEquals("hot", entry(0, "hot\nvery").firstLine(10));
    assertTrue(entry(0, "hot\nvery").more());
    assertEquals("hot", entry(0, "hot\n").firstLine(10));
    assertEquals("very ", entry(0, "very long").firstLine(5) + " ");
  }

  @Test
  void aLogIsWrittenToAFile(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("robot.log");
    assertEquals("saved 2 entries to " + file,
        LogFile.write(List.of(LogLine.of(entry(Log.START, "häßlich")), LogLine.of(entry(Log.START, "b"))), wording,
            file));
    assertEquals(List.of("2026-01-02 03:04:05.000  WARN   [/motor]  häßlich  (motor.cpp:3)",
        "2026-01-02 03:04:05.000  WARN   [/motor]  b  (motor.cpp:3)"), Files.readAllLines(file));
  }

  @Test
  void aFileThatCannotBeWrittenIsTold(@TempDir Path folder) {
    Path nowhere = folder.resolve("missing/robot.log");
    assertTrue(LogFile.write(List.of(), wording, nowhere).startsWith("cannot write " + nowhere));
  }
}
