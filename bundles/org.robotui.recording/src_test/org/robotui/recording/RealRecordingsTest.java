package org.robotui.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.testkit.recorded.SharedData;

/** Recordings of robots, with what their origin says of them. */
@EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
class RealRecordingsTest {

  @TempDir
  private Path folder;

  static Stream<Path> files() {
    return Stream.concat(SharedData.files("bags", ".bag").stream(), SharedData.files("mcap", ".mcap").stream());
  }

  @ParameterizedTest
  @CsvSource({"bags/sena_loop.bag, 898, 1137834225973760000, 1137834284788331000",
      "bags/husky_imu_gps_odom.bag, 16806, 1432235498025042999, 1432235893332159000",
      "bags/stereo_jpeg.bag, 16, 1262304000000000000, 1262304003000000000",
      "bags/tiago_joint_states.bag, 8022, 1600000000000000000, 1600000080210929000",
      "bags/turtlesim.bag, 8647, 1396293887844783943, 1396293909544870199",
      "bags/marker_cube.bag, 2, 1547161992282117000, 1547161992283168000",
      "mcap/talker.mcap, 20, 1585866235112411371, 1585866239643508139",
      "mcap/topics_and_services.mcap, 13, 1697522263121459207, 1697522264629347866"})
  void have_the_messages_and_times_that_are_known_of_them(String name, int messages, long first, long last)
      throws RecordingException {
    try (RecordingReader recording = open(SharedData.file(name))) {
      RecordingInterval span = recording.span().orElseThrow();
      assertTrue(Math.abs(span.start() - first) < 2000 && Math.abs(span.end() - last) < 2000, span.toString());
      List<ReadMessages.Message> read = ReadMessages.of(recording);
      assertEquals(messages, read.size());
      assertEquals(messages, recording.messageCounts().values().stream().mapToLong(Long::longValue).sum());
      assertEquals(List.of(), recording.damages());
      assertEquals(span.start(), read.get(0).logTime());
      assertEquals(span.end(), read.get(read.size() - 1).logTime());
    }
  }

  @Test
  void of_one_robot_are_the_same_in_all_compressions() throws RecordingException {
    List<List<Object>> plain = withoutSchemas(SharedData.file("bags/turtlesim.bag"));
    assertTrue(plain.equals(withoutSchemas(SharedData.file("bags/turtlesim_bz2.bag"))));
    assertTrue(plain.equals(withoutSchemas(SharedData.file("bags/turtlesim_lz4.bag"))));
  }

  @Test
  void name_topics_types_and_definitions() throws RecordingException {
    try (RecordingReader recording = open(SharedData.file("bags/sena_loop.bag"))) {
      assertTrue(recording.isIndexed());
      assertEquals("rosbag 2.0", recording.format());
      assertEquals(Map.of("/scan", 224L, "/odom", 224L, "/tf", 448L, "/tf_static", 1L, "/map", 1L), counts(recording));
      RecordedChannel map = channel(recording, "/map");
      assertEquals("nav_msgs/OccupancyGrid", map.schema().name());
      assertEquals("ros1msg", map.schema().encoding());
      assertEquals("1", map.metadata().get("latching"));
      assertTrue(new String(map.schema().definition()).contains("MapMetaData info"));
    }
    try (RecordingReader recording = open(SharedData.file("mcap/sena_loop.mcap"))) {
      assertEquals(Map.of("/scan", 224L, "/odom", 224L, "/tf", 448L, "/tf_static", 1L, "/map", 1L), counts(recording));
      RecordedChannel map = channel(recording, "/map");
      assertEquals("nav_msgs/msg/OccupancyGrid", map.schema().name());
      assertEquals("cdr", map.messageEncoding());
    }
  }

  @ParameterizedTest
  @MethodSource("files")
  void become_the_same_messages_in_another_file(Path file) throws RecordingException {
    Path copy = folder.resolve("copy.mcap");
    for (ChunkCompression compression : ChunkCompression.values()) {
      try (RecordingReader recording = open(file)) {
        RecordingCopy.copy(recording, copy,
            WriterOptions.defaults().withCompression(compression).withChunkBytes(100_000));
        try (RecordingReader copied = open(copy)) {
          assertTrue(copied.isIndexed());
          assertEquals(recording.span(), copied.span());
          assertEquals(counts(recording), counts(copied));
          assertEquals(recording.channels().size(), copied.channels().size());
          assertEquals(recording.metadata(), copied.metadata());
          assertTrue(ReadMessages.of(recording).equals(ReadMessages.of(copied)));
          assertEquals(List.of(), copied.damages());
        }
      }
    }
  }

  @ParameterizedTest
  @MethodSource("files")
  void of_ROS_1_become_bags(Path file) throws RecordingException {
    for (ChunkCompression compression : ChunkCompression.values()) {
      Path copy = folder.resolve(compression.word() + ".bag");
      WriterOptions options = WriterOptions.defaults().withCompression(compression).withChunkBytes(30_000);
      try (RecordingReader recording = open(file)) {
        boolean fits = recording.channels().stream().allMatch(RecordingCopy::fitsBag);
        if (!fits) {
          assertThrows(IllegalArgumentException.class,
              () -> RecordingCopy.toBag(List.of(recording), RecordingPart.ALL, copy, options, channel -> "*"));
          continue;
        }
        RecordingCopy.toBag(List.of(recording), RecordingPart.ALL, copy, options,
            channel -> channel.metadata().getOrDefault("md5sum", "*"));
        try (RecordingReader copied = open(copy)) {
          assertTrue(copied.isIndexed());
          assertEquals(recording.span(), copied.span());
          assertEquals(counts(recording), counts(copied));
          assertTrue(inBag(recording).equals(inBag(copied)));
          assertEquals(List.of(), copied.damages());
        }
      }
    }
  }

  /** What a bag keeps of messages: neither numbers nor when they were sent. */
  private static List<List<Object>> inBag(RecordingReader recording) throws RecordingException {
    return ReadMessages.of(recording).stream()
        .<List<Object>>map(each -> List.of(each.topic(), each.schema(), each.logTime(), each.data())).toList();
  }

  @ParameterizedTest
  @MethodSource("files")
  void are_read_from_any_time_on(Path file) throws RecordingException {
    try (RecordingReader recording = open(file)) {
      List<ReadMessages.Message> all = ReadMessages.of(recording);
      for (int at = 0; at < all.size(); at += 1 + all.size() / 7) {
        long from = all.get(at).logTime();
        long to = all.get(Math.min(all.size() - 1, at + 50)).logTime();
        String topic = all.get(at).topic();
        Set<Integer> ids = new HashSet<>();
        recording.channels().stream().filter(channel -> channel.topic().equals(topic)).map(RecordedChannel::id)
            .forEach(ids::add);
        assertEquals(
            all.stream().filter(m -> m.logTime() >= from && m.logTime() <= to && m.topic().equals(topic)).toList(),
            ReadMessages.of(recording.cursor(new RecordingInterval(from, to), ids)));
      }
    }
  }

  @ParameterizedTest
  @MethodSource("files")
  void tell_what_was_newest_at_any_time(Path file) throws RecordingException {
    try (RecordingReader recording = open(file)) {
      RecordingCursor cursor = recording.cursor(RecordingInterval.ALWAYS, Set.of());
      Map<Integer, RecordedMessage> newest = new TreeMap<>();
      Optional<RecordedMessage> next = cursor.next();
      for (int i = 0; next.isPresent(); i++) {
        RecordedMessage message = next.get();
        newest.put(message.channel().id(), message);
        next = cursor.next();
        boolean last = next.isEmpty() || next.get().logTime() > message.logTime();
        if (last && i % 400 == 0) {
          for (RecordedChannel channel : recording.channels()) {
            assertEquals(Optional.ofNullable(newest.get(channel.id())),
                recording.latestBefore(channel.id(), message.logTime()));
          }
        }
      }
    }
  }

  @ParameterizedTest
  @EnumSource(ChunkCompression.class)
  void give_their_messages_to_several_readers_at_once(ChunkCompression compression) throws Exception {
    Path copy = folder.resolve("copy.mcap");
    try (RecordingReader recording = open(SharedData.file("bags/turtlesim.bag"))) {
      RecordingCopy.copy(recording, copy, WriterOptions.defaults().withCompression(compression).withChunkBytes(5000));
    }
    try (RecordingReader recording = open(copy)) {
      List<ReadMessages.Message> alone = ReadMessages.of(recording);
      List<List<ReadMessages.Message>> together = Stream.of(1, 2, 3, 4).parallel().map(number -> {
        try {
          return ReadMessages.of(recording);
        } catch (IOException e) {
          throw new IllegalStateException(e);
        }
      }).toList();
      together.forEach(read -> assertTrue(alone.equals(read)));
    }
  }

  private static Map<String, Long> counts(RecordingReader recording) {
    Map<String, Long> counts = new TreeMap<>();
    for (RecordedChannel channel : recording.channels()) {
      counts.merge(channel.topic(), recording.messageCounts().getOrDefault(channel.id(), 0L), Long::sum);
    }
    return counts;
  }

  private static RecordedChannel channel(RecordingReader recording, String topic) {
    return recording.channels().stream().filter(channel -> channel.topic().equals(topic)).findFirst().orElseThrow();
  }

  /** One definition has a blank more than that of the other files. */
  private static List<List<Object>> withoutSchemas(Path file) throws RecordingException {
    try (RecordingReader recording = open(file)) {
      return ReadMessages.of(recording).stream()
          .map(message -> List.<Object>of(message.topic(), message.logTime(), message.data())).toList();
    }
  }

  private static RecordingReader open(Path file) throws RecordingException {
    return Recordings.open(file, ScanProgress.NONE);
  }

  @Test
  void are_read_only() throws RecordingException {
    try (RecordingReader recording = open(SharedData.file("bags/marker_cube.bag"))) {
      ByteBuffer data = ReadMessages.of(recording).get(0).data();
      assertTrue(data.isReadOnly() && data.remaining() > 0);
    }
  }
}
