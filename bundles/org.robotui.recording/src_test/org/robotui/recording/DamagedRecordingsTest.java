package org.robotui.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.github.luben.zstd.Zstd;
import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.testkit.ByteMutator;
import org.robotui.testkit.recorded.SharedData;

/** Recordings that are cut off, damaged, or meant to harm: what is whole in them is read, and the rest is told. */
@Timeout(120)
class DamagedRecordingsTest {

  private static final int CHUNK = 6;
  private static final int CHUNK_INDEX = 8;
  private static final int RECORD_HEAD = 9;

  @TempDir
  private Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"mcap/talker.mcap", "bags/marker_cube.bag", "bags/no_messages.bag"})
  @EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
  void are_read_wherever_they_were_cut_off(String name) throws IOException {
    byte[] whole = Files.readAllBytes(SharedData.file(name));
    List<ReadMessages.Message> all = messages(whole);
    int before = 0;
    for (int length = 0; length < whole.length; length += length < 200 || whole.length - length < 200 ? 1 : 37) {
      byte[] cut = Arrays.copyOf(whole, length);
      if (length < 13) {
        assertTrue(read(cut).isEmpty(), "nothing of " + length + " bytes");
        continue;
      }
      List<ReadMessages.Message> messages = messages(cut);
      assertTrue(all.containsAll(messages) && messages.size() >= before, messages.size() + " at " + length);
      before = messages.size();
    }
    assertEquals(all.size(), before, "the last bytes are those of the index alone");
  }

  @ParameterizedTest
  @CsvSource({"none, 1, 20", "lz4, 1, 20", "zstd, 1, 20"})
  void lose_a_damaged_chunk_and_no_other(String compression, int first, int chunks) throws IOException {
    byte[] whole = written(compression, chunks);
    List<ReadMessages.Message> all = messages(whole);
    List<Integer> places = places(whole, CHUNK);
    for (int chunk = first; chunk < places.size(); chunk++) {
      int end = places.get(chunk) + RECORD_HEAD + (int) buffer(whole).getLong(places.get(chunk) + 1);
      byte[] damaged = whole.clone();
      damaged[end - 20] ^= 0x55;
      for (byte[] bytes : List.of(damaged, Arrays.copyOf(damaged, damaged.length - 3))) {
        try (RecordingReader recording = open(bytes)) {
          List<ReadMessages.Message> messages = ReadMessages.of(recording);
          assertTrue(all.containsAll(messages));
          assertTrue(messages.size() >= all.size() * (places.size() - 1) / places.size() - 1
              && messages.size() < all.size(), messages.size() + " of " + all.size());
          long place = places.get(chunk);
          assertTrue(recording.damages().stream().anyMatch(damage -> damage.offset() == place),
              recording.damages().toString());
        }
      }
    }
  }

  @Test
  void go_on_at_the_next_chunk_where_a_length_lies() throws IOException {
    byte[] whole = written("zstd", 20);
    List<ReadMessages.Message> all = messages(whole);
    List<Integer> places = places(whole, CHUNK);
    for (long lie : new long[]{0, 1, 300, 1L << 20, Long.MAX_VALUE, -1}) {
      byte[] damaged = Arrays.copyOf(whole, whole.length - 1);
      buffer(damaged).putLong(places.get(7) + 1, lie);
      try (RecordingReader recording = open(damaged)) {
        List<ReadMessages.Message> messages = ReadMessages.of(recording);
        assertTrue(all.containsAll(messages) && messages.size() >= all.size() * 18 / 20,
            messages.size() + " of " + all.size() + " with " + lie);
        assertFalse(recording.damages().isEmpty());
      }
    }
  }

  @Test
  void do_not_follow_an_index_that_lies() throws IOException {
    byte[] whole = written("zstd", 5);
    List<ReadMessages.Message> all = messages(whole);
    List<Integer> entries = places(whole, CHUNK_INDEX);
    byte[] loop = whole.clone();
    // the second chunk is said to be the first one: without its checksum the summary looks well
    buffer(loop).putLong(entries.get(1) + RECORD_HEAD + 16, buffer(loop).getLong(entries.get(0) + RECORD_HEAD + 16));
    withoutSum(loop);
    byte[] outside = whole.clone();
    buffer(outside).putLong(entries.get(1) + RECORD_HEAD + 16, whole.length * 2L);
    withoutSum(outside);
    byte[] wrongSum = whole.clone();
    wrongSum[entries.get(0) + RECORD_HEAD] ^= 1;
    for (byte[] bytes : List.of(loop, outside, wrongSum)) {
      try (RecordingReader recording = open(bytes)) {
        assertFalse(recording.isIndexed());
        assertEquals(all, ReadMessages.of(recording));
        assertTrue(recording.damages().get(0).problem().startsWith("the summary cannot be used"),
            recording.damages().toString());
      }
    }
  }

  private static void withoutSum(byte[] bytes) {
    buffer(bytes).putInt(bytes.length - 12, 0);
  }

  @ParameterizedTest
  @ValueSource(strings = {"none", "lz4", "zstd", "bz2", "rot13"})
  void of_a_few_bytes_never_take_gigabytes(String compression) throws IOException {
    for (long claimed : new long[]{1L << 27, 1L << 31, 1L << 40, -1}) {
      byte[] words = compression.equals("none") ? new byte[0] : compression.getBytes(StandardCharsets.US_ASCII);
      byte[] data = new byte[1000];
      ByteBuffer bytes = ByteBuffer.allocate(4000).order(ByteOrder.LITTLE_ENDIAN);
      bytes.put(new byte[]{(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'});
      bytes.put((byte) CHUNK).putLong(40 + words.length + data.length).putLong(0).putLong(0).putLong(claimed).putInt(0)
          .putInt(words.length).put(words).putLong(data.length).put(data);
      long before = taken();
      try (RecordingReader recording = open(Arrays.copyOf(bytes.array(), bytes.position()))) {
        assertEquals(List.of(), ReadMessages.of(recording));
        assertEquals(8, recording.damages().get(0).offset(), recording.damages().toString());
      }
      assertTrue(taken() - before < 10 << 20);
    }
  }

  @Test
  void that_explode_end_at_what_they_say_of_their_size() throws IOException {
    byte[] zeros = new byte[64 << 20];
    byte[] bomb = Zstd.compress(zeros);
    for (int claimed : new int[]{1000, 1 << 20}) {
      ByteBuffer bytes = ByteBuffer.allocate(bomb.length + 200).order(ByteOrder.LITTLE_ENDIAN);
      bytes.put(new byte[]{(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'});
      bytes.put((byte) CHUNK).putLong(44 + bomb.length).putLong(0).putLong(0).putLong(claimed).putInt(0).putInt(4)
          .put("zstd".getBytes(StandardCharsets.US_ASCII)).putLong(bomb.length).put(bomb);
      long before = taken();
      try (RecordingReader recording = open(Arrays.copyOf(bytes.array(), bytes.position()))) {
        assertEquals(List.of(), ReadMessages.of(recording));
        assertTrue(taken() - before < 10 << 20, "64 MiB were in it");
        assertTrue(recording.damages().toString().contains("more than " + claimed + " bytes come out"),
            recording.damages().toString());
      }
    }
  }

  /** What this thread has ever taken of the memory. */
  private static long taken() {
    return ((ThreadMXBean) ManagementFactory.getThreadMXBean()).getCurrentThreadAllocatedBytes();
  }

  @ParameterizedTest
  @CsvSource({"mcap/talker.mcap, 400, 40", "bags/marker_cube.bag, 400, 40", "mcap/sena_loop.mcap, 40, 30",
      "bags/turtlesim_lz4.bag, 20, 15", "bags/turtlesim_bz2.bag, 3, 0"})
  @EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
  void never_break_who_reads_them(String name, int times, int percent) throws IOException {
    byte[] whole = Files.readAllBytes(SharedData.file(name));
    int all = messages(whole).size();
    ByteMutator mutator = new ByteMutator(11);
    long read = 0;
    for (int i = 0; i < times; i++) {
      List<ReadMessages.Message> messages = read(mutator.mutate(whole));
      assertTrue(messages.size() <= 2 * all + 10, messages.size() + " messages");
      read += messages.size();
    }
    assertTrue(read >= (long) times * all * percent / 100, read + " of " + (long) times * all);
  }

  @Test
  @EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
  void that_were_not_finished_are_read_as_far_as_they_go() throws IOException {
    byte[] whole = Files.readAllBytes(SharedData.file("bags/turtlesim.bag"));
    List<ReadMessages.Message> all = messages(whole);
    byte[] active = whole.clone();
    int place = new String(active, 0, 200, StandardCharsets.ISO_8859_1).indexOf("index_pos=") + 10;
    long index = buffer(active).getLong(place);
    buffer(active).putLong(place, 0);
    try (RecordingReader recording = open(Arrays.copyOf(active, (int) index))) {
      assertFalse(recording.isIndexed());
      assertEquals(List.of("the bag was not finished, so that it was read through"),
          recording.damages().stream().map(RecordingDamage::problem).toList());
      assertTrue(all.equals(ReadMessages.of(recording)));
    }
    List<ReadMessages.Message> half = messages(Arrays.copyOf(active, (int) index / 2));
    assertTrue(half.equals(all.subList(0, half.size())) && half.size() > all.size() / 4, half.size() + " messages");
    Arrays.fill(active, 100_000, 100_100, (byte) 0x77);
    try (RecordingReader recording = open(Arrays.copyOf(active, (int) index))) {
      int count = ReadMessages.of(recording).size();
      assertTrue(count > all.size() / 10 && count < all.size(), count + " messages");
      assertTrue(recording.damages().size() > 1);
    }
  }

  @Test
  void of_no_known_format_are_reftaken() throws IOException {
    Path file = Files.write(folder.resolve("text"), "#ROSBAG V1.1\nand so on".getBytes(StandardCharsets.US_ASCII));
    RecordingException refused =
        assertThrows(RecordingException.class, () -> Recordings.open(file, ScanProgress.NONE));
    assertTrue(refused.getMessage().startsWith(file + ", byte 0: this is no recording"), refused.getMessage());
    assertThrows(RecordingException.class, () -> Recordings.open(folder.resolve("none"), ScanProgress.NONE));
    assertThrows(RecordingException.class, () -> Recordings.open(folder, ScanProgress.NONE));
  }

  /** Messages with bytes that do not become much smaller, in chunks. */
  private byte[] written(String compression, int chunks) throws IOException {
    Path file = folder.resolve("written.mcap");
    ChunkCompression how = Arrays.stream(ChunkCompression.values())
        .filter(one -> one.word().equals(compression.replace("none", ""))).findFirst().orElseThrow();
    try (RecordingWriter writer = RecordingWriter.create(file,
        WriterOptions.defaults().withCompression(how).withChunkBytes(4000))) {
      RecordedChannel channel = writer.channel("a", "", RecordedSchema.NONE, Map.of());
      byte[] data = new byte[100];
      Random random = new Random(5);
      for (int i = 0; writer.size() < chunks * 4000L; i++) {
        for (int at = 0; at < 60; at++) {
          data[at] = (byte) random.nextInt();
        }
        writer.write(channel, i, i, i, ByteBuffer.wrap(data));
      }
    }
    return Files.readAllBytes(file);
  }

  /** Where records of a kind begin. */
  private static List<Integer> places(byte[] mcap, int code) {
    List<Integer> places = new ArrayList<>();
    int at = 8;
    while (at < mcap.length - 8) {
      if (mcap[at] == code) {
        places.add(at);
      }
      at += RECORD_HEAD + (int) buffer(mcap).getLong(at + 1);
    }
    return places;
  }

  private static ByteBuffer buffer(byte[] bytes) {
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private List<ReadMessages.Message> messages(byte[] bytes) throws IOException {
    try (RecordingReader recording = open(bytes)) {
      return ReadMessages.of(recording);
    }
  }

  /** What there is, or nothing where it is refused as it should be. */
  private List<ReadMessages.Message> read(byte[] bytes) throws IOException {
    try {
      return messages(bytes);
    } catch (RecordingException e) {
      assertTrue(e.getMessage().contains("damaged.bytes, byte "), e.getMessage());
      return List.of();
    }
  }

  private RecordingReader open(byte[] bytes) throws IOException {
    Path file = Files.write(folder.resolve("damaged.bytes"), bytes);
    return Recordings.open(file, ScanProgress.NONE);
  }
}
