package org.robotui.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.testkit.ByteMutator;
import org.robotui.testkit.recorded.SharedData;

/** Bags of ROS 1 of version 1.2. They are made of bags of version 2.0, which say what must be in them. */
@Timeout(120)
@EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
class OldBagTest {

  @TempDir
  private Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"sena_loop", "turtlesim", "stereo_jpeg", "marker_cube"})
  void have_all_messages_with_their_types_senders_and_times(String name) throws IOException {
    try (RecordingReader recent = Recordings.open(SharedData.file("bags/" + name + ".bag"), ScanProgress.NONE);
        RecordingReader old = open(OldBagFile.of(recent))) {
      assertEquals("rosbag 1.2", old.format());
      assertFalse(old.isIndexed());
      assertEquals(recent.span(), old.span());
      assertEquals(ReadMessages.of(recent), ReadMessages.of(old));
      assertEquals(List.of(), old.damages());
      assertEquals(senders(recent), senders(old));
      RecordedChannel last = old.channels().getLast();
      assertEquals(old.messageCounts().get(last.id()), ReadMessages.of(
          old.cursor(RecordingInterval.ALWAYS, Set.of(last.id()))).size());
    }
  }

  private static Set<Object> senders(RecordingReader recording) {
    Set<Object> senders = new HashSet<>();
    recording.channels().forEach(each -> senders.add(List.of(each.topic(), each.schema(), each.metadata(),
        each.isLatched())));
    return senders;
  }

  @Test
  void are_read_wherever_they_were_cut_off() throws IOException {
    byte[] whole = bytes("marker_cube");
    List<ReadMessages.Message> all = messages(whole);
    int before = 0;
    for (int length = 16; length < whole.length; length += 7) {
      List<ReadMessages.Message> messages = messages(Arrays.copyOf(whole, length));
      assertTrue(all.containsAll(messages) && messages.size() >= before, messages.size() + " at " + length);
      before = messages.size();
    }
    assertEquals(all.size(), before, "the last bytes are those of the index alone");
  }

  @Test
  void go_on_at_the_next_message_where_a_length_lies() throws IOException {
    byte[] whole = bytes("turtlesim");
    List<ReadMessages.Message> all = messages(whole);
    int place = new String(whole, StandardCharsets.ISO_8859_1).indexOf("op=\2", whole.length / 3) - Integer.BYTES;
    int header = startOfHeader(whole, place);
    for (int lie : new int[]{-1, 1, 3, 1 << 21, Integer.MAX_VALUE}) {
      byte[] damaged = whole.clone();
      ByteBuffer.wrap(damaged).order(ByteOrder.LITTLE_ENDIAN).putInt(header, lie);
      try (RecordingReader recording = open(damaged)) {
        List<ReadMessages.Message> messages = ReadMessages.of(recording);
        assertEquals(all.size() - 1, messages.size(), "with " + lie);
        assertTrue(new HashSet<>(all).containsAll(messages));
        assertEquals(header, recording.damages().getFirst().offset());
      }
    }
  }

  /** The length of the header in which a field lies. */
  private static int startOfHeader(byte[] bytes, int field) {
    ByteBuffer view = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    int start = field - Integer.BYTES;
    while (view.getInt(start) < field - start || view.getInt(start) > 400
        || view.getInt(start + Integer.BYTES) < 3 || view.getInt(start + Integer.BYTES) > 100) {
      start--;
    }
    return start;
  }

  @Test
  void survive_all_that_may_be_in_a_file() throws IOException {
    byte[] whole = bytes("marker_cube");
    ByteMutator mutator = new ByteMutator(12);
    for (int i = 0; i < 300; i++) {
      byte[] bytes = mutator.mutate(whole);
      Path file = folder.resolve("mutated.bag");
      Files.write(file, bytes);
      if (Recordings.isOne(file)) {
        messages(bytes);
      }
    }
  }

  @Test
  void leave_out_messages_whose_type_they_do_not_define() throws IOException {
    byte[] whole = bytes("marker_cube");
    String text = new String(whole, StandardCharsets.ISO_8859_1);
    byte[] unknown =
        text.replaceFirst("(?s)md5=(.{32})", "md5=" + "0".repeat(32)).getBytes(StandardCharsets.ISO_8859_1);
    try (RecordingReader recording = open(unknown)) {
      assertEquals(messages(whole).size() - 1, ReadMessages.of(recording).size());
      assertTrue(recording.damages().getFirst().problem().contains("does not come before its message"),
          recording.damages().toString());
    }
  }

  private static byte[] bytes(String name) throws IOException {
    try (RecordingReader recent = Recordings.open(SharedData.file("bags/" + name + ".bag"), ScanProgress.NONE)) {
      return OldBagFile.of(recent);
    }
  }

  private List<ReadMessages.Message> messages(byte[] bytes) throws IOException {
    try (RecordingReader recording = open(bytes)) {
      return ReadMessages.of(recording);
    }
  }

  private RecordingReader open(byte[] bytes) throws IOException {
    Path file = folder.resolve("old.bag");
    Files.write(file, bytes);
    return Recordings.open(file, ScanProgress.NONE);
  }
}
