package org.robotui.lcm.log;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.lcm.SharedData;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.ScanProgress;
import org.robotui.testkit.ByteMutator;

/** Logs as recordings: those of a robot, and damaged ones. */
@Timeout(60)
class LcmRecordingTest {

  private static final TypeLibrary NONE = TypeLibrary.of(List.of(), List.of());

  @TempDir
  private Path folder;

  @Test
  void aRecordedLogHasItsChannelsWithTheirTypes() throws IOException {
    TypeLibrary types = TypeFolder.read(List.of(SharedData.lcm("types")));
    Path file = SharedData.lcm("sena_loop.lcmlog");
    long[] told = new long[1];
    try (RecordingReader recording = LcmRecording.open(file, types, (done, size) -> told[0] = done)) {
      assertEquals(file.toFile().length(), told[0]);
      assertEquals(Map.of("ODOMETRY", 224L, "LASER_FRONT", 224L, "MAP", 2L), recording.channels().stream()
          .collect(Collectors.toMap(RecordedChannel::topic, each -> recording.messageCounts().get(each.id()))));
      assertEquals(new RecordingInterval(1137834225973760000L, 1137834284788331000L), recording.span().orElseThrow());
      RecordedChannel laser = channel(recording, "LASER_FRONT");
      assertEquals("robotdata.laser_scan_t lcm", laser.schema().name() + " " + laser.schema().encoding());
      assertTrue(
          new String(laser.schema().definition(), StandardCharsets.UTF_8).contains("struct robotdata.laser_scan_t"));
      assertEquals(List.of(), recording.damages());
      assertEquals(450, read(recording));
      RecordedMessage map = recording.latestBefore(channel(recording, "MAP").id(), Long.MAX_VALUE).orElseThrow();
      assertEquals(466823, map.data().remaining());
    }
    try (RecordingReader recording = LcmRecording.open(file, NONE, ScanProgress.NONE)) {
      assertEquals("0xe08e10e9d71d6b8e", channel(recording, "LASER_FRONT").metadata().get("fingerprint"));
      assertEquals("", channel(recording, "LASER_FRONT").schema().name());
    }
  }

  @Test
  void aChannelOfTwoTypesIsTwo() throws IOException {
    Path file = log(40);
    try (RecordingReader recording = LcmRecording.open(file, NONE, ScanProgress.NONE)) {
      assertEquals(List.of("A", "A", "B"), recording.channels().stream().map(RecordedChannel::topic).sorted().toList());
      assertEquals(40, read(recording));
    }
    assertTrue(LcmRecording.isOne(file));
    assertFalse(LcmRecording.isOne(folder));
    assertFalse(LcmRecording.isOne(Files.writeString(folder.resolve("text"), "no log")));
  }

  @Test
  void whatIsDamagedIsToldWithItsPlace() throws IOException {
    byte[] whole = Files.readAllBytes(log(40));
    whole[100] ^= 0x55; // in the first event or its neighbour
    byte[] cut = Arrays.copyOf(whole, whole.length - 5);
    Path file = Files.write(folder.resolve("cut"), cut);
    try (RecordingReader recording = LcmRecording.open(file, NONE, ScanProgress.NONE)) {
      assertTrue(read(recording) >= 37);
      assertTrue(recording.damages().getLast().problem().contains("bytes are no event"));
      assertTrue(recording.damages().getLast().offset() > cut.length - 60);
    }
  }

  @Test
  void eventsWhoseTimesAreNoneAreLeftOut() throws IOException {
    Path path = folder.resolve("times.lcmlog");
    try (EventLogWriter writer = EventLogWriter.create(path)) {
      for (long time : new long[]{Long.MIN_VALUE, 1_000_000, Long.MAX_VALUE}) {
        writer.write(time, "A", ByteBuffer.allocate(4));
      }
    }
    try (RecordingReader recording = LcmRecording.open(path, NONE, ScanProgress.NONE)) {
      assertEquals(new RecordingInterval(1_000_000_000, 1_000_000_000), recording.span().orElseThrow());
      assertEquals(1, read(recording));
      assertEquals(2, recording.damages().size());
    }
  }

  @Test
  void damagedLogsComeToAnEnd() throws IOException {
    byte[] whole = Files.readAllBytes(log(40));
    ByteMutator mutator = new ByteMutator(3);
    int most = 0;
    for (int i = 0; i < 500; i++) {
      Path file = Files.write(folder.resolve("damaged"), mutator.mutate(whole));
      try (RecordingReader recording = LcmRecording.open(file, NONE, ScanProgress.NONE)) {
        int read = read(recording);
        assertEquals(recording.messageCounts().values().stream().mapToLong(Long::longValue).sum(), read);
        most = Math.max(most, read);
      }
    }
    assertTrue(most >= 39, "some are read all the same");
  }

  private Path log(int events) throws IOException {
    Path path = folder.resolve("made.lcmlog");
    try (EventLogWriter writer = EventLogWriter.create(path)) {
      for (int i = 0; i < events; i++) {
        ByteBuffer data = ByteBuffer.allocate(i % 3 == 0 ? 4 : 20);
        if (i % 3 != 0) {
          data.putLong(0, i % 2);
        }
        writer.write(1_000_000L * i, i % 3 == 0 ? "B" : "A", data);
      }
    }
    return path;
  }

  private static RecordedChannel channel(RecordingReader recording, String topic) {
    return recording.channels().stream().filter(each -> each.topic().equals(topic)).findFirst().orElseThrow();
  }

  private static int read(RecordingReader recording) throws IOException {
    RecordingCursor cursor = recording.cursor(RecordingInterval.ALWAYS, Set.of());
    int count = 0;
    long before = Long.MIN_VALUE;
    for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
      assertTrue(next.get().logTime() >= before);
      before = next.get().logTime();
      count++;
    }
    return count;
  }
}
