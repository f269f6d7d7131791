package org.robotui.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.github.luben.zstd.Zstd;
import com.github.luben.zstd.ZstdInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.testkit.ByteMutator;

/** Recordings of rosbag2, as tests/e2e/peers/rosbag2_maker.py writes them, whole and damaged. */
@Timeout(120)
class Rosbag2Test {

  private static final long FIRST = 1_700_000_000_000_000_000L;
  private static final long STEP = 50_000_000;
  private static final int MESSAGES = 60;
  private static final String PACKED = "sqlite3-file.db3.zstd";

  @TempDir
  private Path folder;

  @Test
  void a_database_has_its_messages_with_definitions() throws IOException {
    Path file = Files.write(folder.resolve("alone.db3"), plain(PACKED));
    try (RecordingReader recording = Recordings.open(file, ScanProgress.NONE)) {
      assertEquals("rosbag2 sqlite3", recording.format());
      assertEquals(List.of(), recording.damages());
      assertEquals(new RecordingInterval(FIRST, FIRST + (MESSAGES - 1) * STEP), recording.span().orElseThrow());
      assertEquals(Map.of("/joint_states", 60L, "/robot/words", 6L, "/picture", 6L), counts(recording));
      RecordedSchema joints = channel(recording, "/joint_states").schema();
      assertEquals("sensor_msgs/msg/JointState ros2msg", joints.name() + " " + joints.encoding());
      assertTrue(new String(joints.definition(), StandardCharsets.UTF_8).contains("float64[] effort"));
      List<ReadMessages.Message> all = ReadMessages.of(recording);
      assertEquals(72, all.size());
      // 5000 bytes of it lie in other pages than its row
      ByteBuffer picture = all.get(71 - 9).data().duplicate().order(ByteOrder.LITTLE_ENDIAN);
      assertEquals((byte) 99, picture.get(picture.limit() - 5000 + 99));
      RecordedMessage words = recording.latestBefore(channel(recording, "/robot/words").id(), FIRST + 25 * STEP)
          .orElseThrow();
      assertEquals(FIRST + 20 * STEP + 1000, words.logTime());
      assertEquals("step 20\0", StandardCharsets.UTF_8.decode(words.data().duplicate().position(8)).toString());
      assertEquals(3, some(recording, FIRST + 10 * STEP, FIRST + 10 * STEP + 2000).size());
    }
  }

  @Test
  void what_a_killed_recorder_left_is_read_with_its_log() throws IOException {
    Path file = Files.write(folder.resolve("killed_0.db3"), plain("killed.db3.zstd"));
    int without = count(file);
    Files.write(folder.resolve("killed_0.db3-wal"), plain("killed.db3-wal.zstd"));
    try (RecordingReader recording = Recordings.open(folder, ScanProgress.NONE)) {
      assertEquals(MESSAGES, ReadMessages.of(recording).size());
      assertTrue(without > 10 && without < MESSAGES, without + " are in the file itself");
      assertTrue(channel(recording, "/words").isLatched());
      assertEquals("", channel(recording, "/words").schema().encoding());
      assertTrue(recording.damages().getFirst().problem().startsWith("there is no metadata.yaml"));
    }
    byte[] log = plain("killed.db3-wal.zstd");
    log[32 + 10 * 536 + 100] ^= 1; // what follows the tenth page is not whole
    Files.write(folder.resolve("killed_0.db3-wal"), log);
    int less = count(file);
    assertTrue(less > without && less < MESSAGES, less + " with ten pages of the log");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "metadata.yaml"})
  void a_folder_of_several_files_is_one_recording(String name) throws IOException {
    Files.write(folder.resolve("run_0.db3.zstd"), packed(PACKED));
    part("run_1.mcap", FIRST + 10 * STEP, data -> data);
    metadata("", "run_0.db3.zstd", "run_1.mcap", "run_2.mcap");
    try (RecordingReader recording =
        Recordings.open(name.isEmpty() ? folder : folder.resolve(name), ScanProgress.NONE)) {
      assertEquals(Map.of("/joint_states", 60L, "/robot/words", 6L, "/picture", 6L, "/more", 20L), counts(recording));
      assertEquals(4, recording.channels().size());
      List<ReadMessages.Message> all = ReadMessages.of(recording);
      assertEquals(92, all.size());
      assertEquals(all.stream().map(ReadMessages.Message::logTime).sorted().toList(),
          all.stream().map(ReadMessages.Message::logTime).toList());
      assertTrue(Recordings.isOne(folder));
      assertEquals(1, recording.damages().size());
      assertTrue(recording.damages().getFirst().problem().contains("run_2.mcap"), "it is not there");
      assertEquals("humble", recording.metadata().getFirst().values().get("ros_distro"));
    }
    assertEquals(List.of("metadata.yaml", "run_0.db3.zstd", "run_1.mcap"), names(folder));
  }

  @Test
  void messages_that_are_compressed_one_by_one_are_as_they_were() throws IOException {
    part("run_0.mcap", FIRST, data -> Zstd.compress(data));
    metadata("MESSAGE", "run_0.mcap");
    for (Path each : List.of(folder, folder.resolve("run_0.mcap"))) {
      try (RecordingReader recording = Recordings.open(each, ScanProgress.NONE)) {
        assertEquals("this is 7", text(ReadMessages.of(recording).get(7).data()));
        assertEquals(List.of(), recording.damages());
      }
    }
    part("run_0.mcap", FIRST, data -> data.length % 2 == 0 ? data : Zstd.compress(data));
    try (RecordingReader recording = Recordings.open(folder, ScanProgress.NONE)) {
      assertEquals(10, ReadMessages.of(recording).size(), "of twenty, ten are not compressed at all");
      assertEquals(10, recording.damages().size());
    }
  }

  @Test
  void other_databases_and_folders_are_refused() throws IOException {
    byte[] other = plain("killed.db3.zstd");
    byte[] name = "messages".getBytes(StandardCharsets.US_ASCII);
    for (int i = 0; i < other.length - name.length; i++) {
      if (Arrays.equals(other, i, i + name.length, name, 0, name.length)) {
        other[i] = 'M';
      }
    }
    Path file = Files.write(folder.resolve("other.db3"), other);
    RecordingException refused = assertThrows(RecordingException.class, () -> Recordings.open(file, ScanProgress.NONE));
    assertTrue(refused.getMessage().contains("it has no table 'messages'"), refused.getMessage());
    Files.writeString(folder.resolve("metadata.yaml"), "- [nothing");
    refused = assertThrows(RecordingException.class, () -> Recordings.open(folder, ScanProgress.NONE));
    assertTrue(refused.getMessage().contains("no file of this recording"), refused.getMessage());
  }

  @Test
  void of_a_file_that_was_cut_off_what_is_there_is_read() throws IOException {
    byte[] whole = plain(PACKED);
    int before = 0;
    for (int length = 0; length <= whole.length; length += length < 100 ? 10 : 509) {
      int read = read(Arrays.copyOf(whole, length));
      before = Math.max(before, read);
      assertTrue(read <= 72, read + " at " + length);
    }
    assertTrue(before > 60, before + " with the last bytes missing");
    assertEquals(72, read(whole));
  }

  @ParameterizedTest
  @ValueSource(strings = {PACKED, "killed.db3.zstd"})
  void damaged_databases_come_to_an_end(String name) throws IOException {
    byte[] whole = plain(name);
    ByteMutator mutator = new ByteMutator(Long.getLong("robotui.seed", 7));
    int most = 0;
    for (int i = 0; i < 1500; i++) {
      most = Math.max(most, read(mutator.mutate(whole)));
    }
    assertTrue(most >= 30, "some are read all the same: " + most);
  }

  @Test
  void damaged_logs_come_to_an_end() throws IOException {
    Path file = Files.write(folder.resolve("killed.db3"), plain("killed.db3.zstd"));
    byte[] log = plain("killed.db3-wal.zstd");
    ByteMutator mutator = new ByteMutator(8);
    for (int i = 0; i < 300; i++) {
      Files.write(folder.resolve("killed.db3-wal"), mutator.mutate(log));
      assertTrue(count(file) <= MESSAGES);
    }
  }

  private interface Packing {
    byte[] of(byte[] data);
  }

  private void part(String name, long first, Packing packing) throws IOException {
    Files.deleteIfExists(folder.resolve(name));
    try (RecordingWriter writer = RecordingWriter.create(folder.resolve(name), WriterOptions.defaults())) {
      RecordedChannel channel = writer.channel("/more", "json", RecordedSchema.NONE, Map.of());
      for (int i = 0; i < 20; i++) {
        byte[] data = ("this is " + i).getBytes(StandardCharsets.UTF_8);
        writer.write(channel, first + i * STEP, first, 0, ByteBuffer.wrap(packing.of(data)));
      }
    }
  }

  private void metadata(String mode, String... files) throws IOException {
    Files.writeString(folder.resolve("metadata.yaml"),
        "rosbag2_bagfile_information:\n  version: 5\n  ros_distro: humble\n"
            + "  compression_mode: '" + mode + "'\n  relative_file_paths:\n"
            + Stream.of(files).map(file -> "    - bag/" + file + "\n").collect(Collectors.joining()));
  }

  private static String text(ByteBuffer data) {
    return StandardCharsets.UTF_8.decode(data.duplicate()).toString();
  }

  private static List<String> names(Path folder) throws IOException {
    try (Stream<Path> all = Files.list(folder)) {
      return all.map(each -> each.getFileName().toString()).sorted().toList();
    }
  }

  private static Map<String, Long> counts(RecordingReader recording) {
    return recording.channels().stream()
        .collect(Collectors.toMap(RecordedChannel::topic, each -> recording.messageCounts().get(each.id())));
  }

  private static RecordedChannel channel(RecordingReader recording, String topic) {
    return recording.channels().stream().filter(each -> each.topic().equals(topic)).findFirst().orElseThrow();
  }

  private static List<RecordedMessage> some(RecordingReader recording, long from, long to) throws RecordingException {
    List<RecordedMessage> some = new ArrayList<>();
    RecordingCursor cursor = recording.cursor(new RecordingInterval(from, to), Set.of());
    for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
      some.add(next.get());
    }
    return some;
  }

  private int count(Path file) throws RecordingException {
    try (RecordingReader recording = Recordings.open(file, ScanProgress.NONE)) {
      return ReadMessages.of(recording).size();
    }
  }

  /** How many messages there are, or none where it is refused as it should be. */
  private int read(byte[] bytes) throws IOException {
    Path file = Files.write(folder.resolve("damaged.bytes"), bytes);
    try {
      return count(file);
    } catch (RecordingException e) {
      assertTrue(e.getMessage().contains("damaged.bytes, byte "), e.getMessage());
      return 0;
    }
  }

  private static byte[] packed(String name) throws IOException {
    try (InputStream stream = Rosbag2Test.class.getResourceAsStream("rosbag2/" + name)) {
      return stream.readAllBytes();
    }
  }

  private static byte[] plain(String name) throws IOException {
    try (InputStream stream = new ZstdInputStream(Rosbag2Test.class.getResourceAsStream("rosbag2/" + name))) {
      return stream.readAllBytes();
    }
  }
}
