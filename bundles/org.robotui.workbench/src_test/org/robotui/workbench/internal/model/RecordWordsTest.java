package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.record.RecorderState;
import org.robotui.api.record.RecordingStatus;

class RecordWordsTest {
  private static final Instant SINCE = Instant.parse("2026-11-27T10:00:00Z");

  private static RecordingStatus status(String... problems) {
    return new RecordingStatus(List.of(Path.of("/data/run.mcap")), SINCE, 4_823_450, 1000, 0, List.of(), 120L << 30,
        List.of(problems));
  }

  private static RecordWords recording(Duration time, String... problems) {
    return RecordWords.of(new RecorderState(Optional.of(status(problems)), Optional.empty(), Optional.empty()),
        SINCE.plus(time));
  }

  @Test
  void aRecordingSaysItsTimeItsSizeAndWhatIsLeft() {
    assertEquals(new RecordWords(true, "0:12   4.6 MB", "Recording to /data/run.mcap\n120.0 GB left on the disk"),
        recording(Duration.ofSeconds(12)));
    assertEquals("1:01:05   4.6 MB", recording(Duration.ofSeconds(3665)).text());
  }

  @Test
  void problemsAreInTheHint() {
    assertEquals(
        "Recording to /data/run.mcap\n120.0 GB left on the disk\n7 messages could not be taken in time",
        recording(Duration.ofSeconds(1), "7 messages could not be taken in time").hint());
  }

  @Test
  void whatEndedByItselfSaysWhy() {
    RecorderState ended = new RecorderState(Optional.empty(),
        Optional.of(new RecorderState.Ended(status(), "the disk is nearly full")), Optional.empty());

    assertEquals(new RecordWords(false, "Record", "The recording has ended: the disk is nearly full"),
        RecordWords.of(ended, SINCE));
  }

  @Test
  void theLastSecondsAreTold() {
    RecorderState kept = new RecorderState(Optional.empty(), Optional.empty(),
        Optional.of(new RecorderState.Recent(Duration.ofSeconds(30), Duration.ofSeconds(21), 1000, 10, false)));

    assertEquals("Record what the robots send; the last 21 s are kept", RecordWords.of(kept, SINCE).hint());
  }
}
