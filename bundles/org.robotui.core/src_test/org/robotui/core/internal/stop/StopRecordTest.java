package org.robotui.core.internal.stop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StopRecordTest {
  @TempDir
  private Path folder;

  private StopRecord record() {
    return new StopRecord(folder, Runnable::run, Instant::now);
  }

  private Path own() {
    return folder.resolve("left-" + ProcessHandle.current().pid() + ".txt");
  }

  @Test
  void itStandsThereAsLongAsTheStopIsLatched() throws IOException {
    StopRecord record = record();
    record.stopped("Keira", "You");
    record.hangs("the display has not answered for 0.3 s");
    assertTrue(Files.readString(own()).contains("Keira was stopped by You"));
    record.answers();
    assertFalse(Files.readString(own()).contains("display"));
    record.released("Keira");
    assertFalse(Files.exists(own()));
  }

  @Test
  void whatAProcessThatLivesHasWrittenIsItsOwn() {
    record().stopped("Keira", "You");
    assertEquals(List.of(), record().takeLeft());
  }

  @Test
  void whatAProcessLeftIsToldOnce() throws IOException {
    record().stopped("Keira", "You");
    Path left = Files.move(own(), folder.resolve("left-999999999.txt"));
    List<String> told = record().takeLeft();
    assertEquals(1, told.size());
    assertTrue(told.getFirst().contains("process 999999999") && told.getFirst().contains("Keira was stopped by You"),
        told.toString());
    assertFalse(Files.exists(left));
    assertEquals(List.of(), record().takeLeft());
  }

  @Test
  void anotherProcessOfTheSameNumberIsNotTheOneThatLeftIt() throws IOException {
    Files.writeString(own(), "2001-01-01T00:00:00Z\n2001-01-01 00:00:09  Keira was stopped by You\n");
    assertEquals(1, record().takeLeft().size());
  }
}
