package org.robotui.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Recordings as they are written and read again. */
class RecordingWriterTest {

  private static final RecordedSchema POSE = new RecordedSchema("turtlesim/msg/Pose", "ros2msg", bytes("float32 x"));

  @TempDir
  private Path folder;
  private Path file;

  @BeforeEach
  void name() {
    file = folder.resolve("recording.mcap");
  }

  @Test
  void keep_channels_of_any_framework_side_by_side() throws RecordingException {
    try (RecordingWriter writer = RecordingWriter.create(file, WriterOptions.defaults())) {
      RecordedChannel pose = writer.channel("/pose", "cdr", POSE, Map.of("qos", "reliable"));
      RecordedChannel same = writer.channel("/pose2", "cdr", POSE, Map.of());
      RecordedChannel raw = writer.channel("LASER", "lcm", RecordedSchema.NONE, Map.of());
      RecordedChannel silent = writer.channel("/silent", "json", POSE, Map.of());
      assertEquals(3, silent.id());
      writer.write(raw, 30, 25, 7, ByteBuffer.wrap(bytes("lcm")));
      writer.write(pose, 10, 5, 0xffff_ffffL, ByteBuffer.wrap(bytes("xpose"), 1, 4));
      writer.write(same, 20, 20, 0, ByteBuffer.allocate(0));
    }
    try (RecordingReader recording = open()) {
      assertTrue(recording.isIndexed());
      assertEquals(List.of("/pose", "/pose2", "LASER", "/silent"),
          recording.channels().stream().map(RecordedChannel::topic).toList());
      assertEquals(Map.of("qos", "reliable"), recording.channels().get(0).metadata());
      assertEquals(Optional.of(new RecordingInterval(10, 30)), recording.span());
      assertEquals(
          List.of(new ReadMessages.Message("/pose", "cdr", POSE, 10, 5, 0xffff_ffffL, ByteBuffer.wrap(bytes("pose"))),
              new ReadMessages.Message("/pose2", "cdr", POSE, 20, 20, 0, ByteBuffer.allocate(0)),
              new ReadMessages.Message("LASER", "lcm", RecordedSchema.NONE, 30, 25, 7, ByteBuffer.wrap(bytes("lcm")))),
          ReadMessages.of(recording));
    }
  }

  @Test
  void keep_files_and_notes() throws RecordingException {
    try (RecordingWriter writer = RecordingWriter.create(file, WriterOptions.defaults())) {
      writer.attach("robot.yaml", "text/yaml", 5, 4, ByteBuffer.wrap(bytes("name: natalie")));
      writer.note(new RecordedMetadata("session", Map.of("place", "lab")));
    }
    for (int cut : new int[]{0, 30}) {
      cut(cut);
      try (RecordingReader recording = open()) {
        assertEquals(cut == 0, recording.isIndexed());
        assertEquals(List.of(new RecordedMetadata("session", Map.of("place", "lab"))), recording.metadata());
        RecordedAttachment attachment = recording.attachments().get(0);
        assertEquals("robot.yaml text/yaml 5 4 13", attachment.name() + " " + attachment.mediaType() + " "
            + attachment.logTime() + " " + attachment.createTime() + " " + attachment.size());
        assertEquals(ByteBuffer.wrap(bytes("name: natalie")), recording.content(attachment));
        assertEquals(Optional.empty(), recording.span());
      }
    }
  }

  @ParameterizedTest
  @EnumSource(ChunkCompression.class)
  void are_in_order_of_their_times_whatever_the_order_of_writing(ChunkCompression compression)
      throws RecordingException {
    Random random = new Random(4);
    try (RecordingWriter writer = RecordingWriter.create(file,
        WriterOptions.defaults().withCompression(compression).withChunkBytes(500))) {
      RecordedChannel[] channels = {writer.channel("a", "", RecordedSchema.NONE, Map.of()),
          writer.channel("b", "", RecordedSchema.NONE, Map.of())};
      for (int i = 0; i < 3000; i++) {
        long time = i - random.nextInt(200);
        writer.write(channels[i % 2], time, time, i, ByteBuffer.allocate(4 + random.nextInt(60)).putInt(0, i));
      }
    }
    try (RecordingReader recording = open()) {
      List<ReadMessages.Message> messages = ReadMessages.of(recording);
      assertEquals(3000, messages.size());
      for (int i = 1; i < messages.size(); i++) {
        assertTrue(messages.get(i - 1).logTime() <= messages.get(i).logTime());
      }
      for (long time = -300; time < 3100; time += 97) {
        long at = time;
        Optional<Long> expected = messages.stream().filter(m -> m.topic().equals("b") && m.logTime() <= at)
            .reduce((one, other) -> other).map(ReadMessages.Message::sequence);
        assertEquals(expected, recording.latestBefore(1, at).map(RecordedMessage::sequence), "at " + at);
        assertEquals(messages.stream().filter(m -> m.topic().equals("a") && m.logTime() >= at).toList(),
            ReadMessages.of(recording.cursor(RecordingInterval.from(at), Set.of(0))));
      }
    }
  }

  @Test
  @Timeout(20)
  void are_with_the_system_soon_after_they_were_written() throws Exception {
    try (RecordingWriter writer =
        RecordingWriter.create(file, WriterOptions.defaults().withChunkTime(Duration.ofMillis(20)))) {
      RecordedChannel channel = writer.channel("a", "", RecordedSchema.NONE, Map.of());
      long empty = writer.size();
      writer.write(channel, 1, 1, 0, ByteBuffer.allocate(100));
      while (writer.size() == empty) {
        Thread.sleep(5);
      }
      // as it would be left behind by a process that is killed
      Path left = folder.resolve("left.mcap");
      Files.copy(file, left, StandardCopyOption.REPLACE_EXISTING);
      try (RecordingReader recording = Recordings.open(left, ScanProgress.NONE)) {
        assertFalse(recording.isIndexed());
        assertEquals(1, ReadMessages.of(recording).size());
      }
    }
    try (RecordingReader recording = open()) {
      assertTrue(recording.isIndexed());
      assertEquals(1, ReadMessages.of(recording).size());
    }
  }

  @Test
  void become_whole_by_a_copy() throws Exception {
    try (RecordingWriter writer = RecordingWriter.create(file, WriterOptions.defaults().withChunkBytes(1000))) {
      RecordedChannel channel = writer.channel("a", "", POSE, Map.of());
      writer.attach("f", "", 1, 0, ByteBuffer.wrap(bytes("content")));
      for (int i = 0; i < 1000; i++) {
        writer.write(channel, i, i, i, ByteBuffer.allocate(50));
      }
    }
    Files.write(file, Arrays.copyOf(Files.readAllBytes(file), (int) Files.size(file) / 2));
    Path whole = folder.resolve("whole.mcap");
    try (RecordingReader recording = open()) {
      RecordingCopy.Outcome outcome = RecordingCopy.copy(recording, whole, WriterOptions.defaults());
      assertTrue(outcome.messages() > 200 && !outcome.damages().isEmpty(), outcome.toString());
      assertThrows(IllegalArgumentException.class,
          () -> RecordingCopy.copy(recording, file, WriterOptions.defaults()));
      try (RecordingReader repaired = Recordings.open(whole, ScanProgress.NONE)) {
        assertTrue(repaired.isIndexed() && repaired.damages().isEmpty());
        assertEquals(ReadMessages.of(recording), ReadMessages.of(repaired));
        assertEquals(ByteBuffer.wrap(bytes("content")), repaired.content(repaired.attachments().get(0)));
      }
    }
  }

  @Test
  void refuse_what_is_not_theirs() throws RecordingException {
    RecordingWriter writer = RecordingWriter.create(file, WriterOptions.defaults());
    RecordedChannel mine = writer.channel("a", "", RecordedSchema.NONE, Map.of());
    RecordedChannel other = new RecordedChannel(0, "b", "", RecordedSchema.NONE, Map.of());
    assertThrows(IllegalArgumentException.class, () -> writer.write(other, 0, 0, 0, ByteBuffer.allocate(1)));
    writer.close();
    writer.close();
    assertThrows(IllegalStateException.class, () -> writer.write(mine, 0, 0, 0, ByteBuffer.allocate(1)));
    Path nowhere = folder.resolve("none/recording.mcap");
    RecordingException refused =
        assertThrows(RecordingException.class, () -> RecordingWriter.create(nowhere, WriterOptions.defaults()));
    assertTrue(refused.getMessage().startsWith(nowhere + " cannot be written"), refused.getMessage());
    assertThrows(IllegalArgumentException.class, () -> WriterOptions.defaults().withChunkBytes(0));
    assertThrows(IllegalArgumentException.class, () -> WriterOptions.defaults().withChunkTime(Duration.ZERO));
  }

  private void cut(int bytes) {
    try {
      byte[] all = Files.readAllBytes(file);
      Files.write(file, Arrays.copyOf(all, all.length - bytes));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private RecordingReader open() throws RecordingException {
    return Recordings.open(file, ScanProgress.NONE);
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }
}
