package org.robotui.message.topic;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;

class ServerNoticesTest {
  private static final String SERVER = "ws://robot:9090";
  private final ServerNotices notices = new ServerNotices(SERVER);

  private List<LogEntry> taken() {
    List<LogEntry> taken = new ArrayList<>();
    notices.take(taken::add);
    return taken;
  }

  @Test
  void whatWasSaidIsTakenOnceAndInOrder() {
    notices.said(Severity.ERROR, "no such topic");
    notices.said(Severity.INFO, "welcome");
    assertEquals(List.of(new LogEntry(Severity.ERROR, SERVER, "no such topic", ""),
        new LogEntry(Severity.INFO, SERVER, "welcome", "")), taken());
    assertEquals(List.of(), taken());
  }

  @Test
  void aServerThatNeverStopsFillsNoMemory() {
    IntStream.range(0, 1_000).forEach(i -> notices.said(Severity.INFO, "word " + i));
    List<LogEntry> taken = taken();
    assertEquals(100, taken.size());
    assertEquals("word 0", taken.getFirst().message());
  }
}
