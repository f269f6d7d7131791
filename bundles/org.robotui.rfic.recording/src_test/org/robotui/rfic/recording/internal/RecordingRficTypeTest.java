package org.robotui.rfic.recording.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Setting;
import org.robotui.api.config.SettingFault;
import org.robotui.rfic.recording.internal.file.RecordingFiles;
import org.robotui.rfic.recording.internal.time.SharedTimeline;
import org.robotui.testkit.FakeSettings;

class RecordingRficTypeTest {
  private final RecordingRficType type = new RecordingRficType(new SharedTimeline());
  @TempDir
  private Path folder;

  private List<String> faults(String file) {
    FakeSettings settings = new FakeSettings(type.schema());
    settings.set("file", new Placed(file, folder.resolve("robot.yaml").toString(), 5, 13));
    return type.faults(settings.current()).stream().map(SettingFault::toString).toList();
  }

  @Test
  void aFileThatCannotBePlayedIsNamedWithItsPlace() throws IOException {
    Files.writeString(folder.resolve("notes.txt"), "no recording");
    Files.write(folder.resolve("short.bag"), new byte[3]);
    String place = folder.resolve("robot.yaml") + ":5:13: 'file': ";
    assertEquals(
        List.of(place + "run.mcap is not there; write where the recording is, relative to this file"),
        faults("run.mcap"));
    assertEquals(List.of(place + ". is no folder of rosbag2; name one, or a file; " + RecordingFiles.KNOWN + " are"),
        faults("."));
    for (String other : List.of("notes.txt", "short.bag")) {
      assertEquals(List.of(
          place + other + " is no recording that is known here; " + RecordingFiles.KNOWN + " are"),
          faults(other));
    }
    assertTrue(faults("a\0b").getFirst().contains("is no name of a file"));
    try (SmallRecording recording = new SmallRecording(folder.resolve("run.mcap"))) {
      recording.odometry("/odom", 0, 1);
    }
    assertEquals(List.of(), faults("run.mcap"));
    Files.createDirectories(folder.resolve("bag"));
    Files.move(folder.resolve("run.mcap"), folder.resolve("bag/run_0.mcap"));
    assertEquals(List.of(), faults("bag"));
  }

  @Test
  void nothingThatCommandsCanBeSet() {
    assertEquals("file, types, namespace, topics, tf, offset, play, loop",
        type.schema().settings().stream().map(Setting::name).collect(Collectors.joining(", ")));
  }
}
