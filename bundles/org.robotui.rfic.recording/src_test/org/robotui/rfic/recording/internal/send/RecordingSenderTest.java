package org.robotui.rfic.recording.internal.send;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingPart;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.RecordingWriter;
import org.robotui.recording.Recordings;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.WriterOptions;
import org.robotui.rfic.recording.internal.SmallRecording;

/** When messages of a recording are sent. */
class RecordingSenderTest {
  private static final long SECOND = 1_000_000_000L;
  private static final long BEGIN = 1_700_000_000L * SECOND;

  /** What was sent, with the time at which it was. */
  private static final class Told implements FrameworkSender, SendTime {
    private final List<String> sent = new ArrayList<>();
    private final List<Long> clock = new ArrayList<>();
    private long now = 5 * SECOND;
    private int finished;
    private int most = Integer.MAX_VALUE;
    private long heardFrom;

    @Override
    public void send(RecordedMessage message) {
      sent.add(message.channel().topic() + " " + (now - 5 * SECOND) / 1_000_000L);
      if (sent.size() == most) {
        Thread.currentThread().interrupt();
      }
    }

    @Override
    public void clock(long nanos) {
      clock.add(nanos - BEGIN);
    }

    @Override
    public boolean isHeard() {
      return now >= heardFrom;
    }

    @Override
    public void finish() {
      finished++;
    }

    @Override
    public void close() {
      finished = -1;
    }

    @Override
    public long nanos() {
      return now;
    }

    @Override
    public void pass(long nanos) {
      now += nanos;
    }
  }

  @TempDir
  private Path folder;
  private RecordingReader recording;
  private final Told told = new Told();

  @BeforeEach
  void record() throws Exception {
    Path file = folder.resolve("run.mcap");
    try (SmallRecording writer = new SmallRecording(file)) {
      writer.say("/map", SmallRecording.ODOMETRY, Map.of("latching", "1"), 0, Map.of());
      writer.odometry("/odom", 0.5, 1).odometry("/odom", 1, 2).odometry("/odom", 3, 3);
      writer.odometry("/other", 2, 0);
    }
    recording = Recordings.open(file, ScanProgress.NONE);
  }

  @AfterEach
  void close() {
    recording.close();
  }

  private RecordingSender sender(double from, double to, Set<String> topics) {
    Map<Integer, FrameworkSender> byChannel = new HashMap<>();
    recording.channels().stream().filter(each -> topics.contains(each.topic()))
        .forEach(each -> byChannel.put(each.id(), told));
    return new RecordingSender(recording,
        new RecordingInterval(BEGIN + Math.round(from * SECOND), BEGIN + Math.round(to * SECOND)), byChannel, Set.of(),
        told);
  }

  @Test
  void they_are_sent_at_their_distances_and_the_time_is_said() throws IOException {
    assertEquals(5, sender(0, 3, Set.of("/map", "/odom", "/other")).send(new SendPace(1, false, Duration.ZERO, false)));
    assertEquals(List.of("/map 0", "/odom 500", "/odom 1000", "/other 2000", "/odom 3000"), told.sent);
    assertEquals(1, told.finished);
    assertEquals(0, told.clock.getFirst());
    assertEquals(3 * SECOND, told.clock.getLast());
    for (int i = 1; i < told.clock.size(); i++) {
      long step = told.clock.get(i) - told.clock.get(i - 1);
      assertTrue(step >= 0 && step <= 10_000_000L, "after " + told.clock.get(i - 1) + " comes " + told.clock.get(i));
    }
  }

  @Test
  void a_part_begins_with_what_holds_and_goes_faster() throws IOException {
    assertEquals(3, sender(1, 3, Set.of("/map", "/odom")).send(new SendPace(4, false, Duration.ofSeconds(1), false)));
    assertEquals(List.of("/map 1000", "/odom 1000", "/odom 1500"), told.sent);
    assertEquals(SECOND, told.clock.getFirst());
  }

  @Test
  void nothing_is_sent_before_somebody_listens() throws IOException {
    told.heardFrom = 9 * SECOND;
    sender(0, 3, Set.of("/odom")).send(new SendPace(1, false, Duration.ofSeconds(1), true));
    assertEquals(List.of("/odom 4500", "/odom 5000", "/odom 7000"), told.sent);
  }

  @Test
  void a_loop_begins_again_until_it_is_ended() throws IOException {
    told.most = 7;
    sender(0, 3, Set.of("/odom")).send(new SendPace(1, true, Duration.ZERO, false));
    assertTrue(Thread.interrupted(), "who asked is told");
    assertEquals(List.of("/odom 500", "/odom 1000", "/odom 3000", "/odom 3500", "/odom 4000", "/odom 6000",
        "/odom 6500"), told.sent);
    assertTrue(told.clock.indexOf(0L) < told.clock.lastIndexOf(0L), "the time goes back");
    assertEquals(0, told.finished);
  }

  @Test
  void what_has_no_framework_cannot_be_sent() throws Exception {
    Path file = folder.resolve("odd.mcap");
    try (SmallRecording writer = new SmallRecording(file)) {
      writer.raw("/odd", "msgpack", 1, new byte[]{1});
    }
    try (RecordingReader odd = Recordings.open(file, ScanProgress.NONE)) {
      IOException refused = assertThrows(IOException.class, () -> RecordingSender.open(odd,
          new RecordingPart(RecordingInterval.ALWAYS, channel -> true), false, Map.of(), Thread::new));
      assertTrue(refused.getMessage().endsWith("here are /odd (msgpack)"), refused.getMessage());
    }
  }

  @Test
  void a_master_that_is_not_there_is_named() throws Exception {
    Path file = folder.resolve("one.mcap");
    try (RecordingWriter writer = RecordingWriter.create(file, WriterOptions.defaults())) {
      writer.write(writer.channel("/x", "ros1", new RecordedSchema("std_msgs/String", "ros1msg",
          "string data\n".getBytes(StandardCharsets.UTF_8)), Map.of()), BEGIN, BEGIN, 0, ByteBuffer.allocate(4));
    }
    try (RecordingReader one = Recordings.open(file, ScanProgress.NONE)) {
      IOException refused = assertThrows(IOException.class, () -> RecordingSender.open(one,
          new RecordingPart(RecordingInterval.ALWAYS, channel -> true), false,
          Map.of("ROS_MASTER_URI", "http://127.0.0.1:1", "ROS_IP", "127.0.0.1"), daemon -> {
            Thread thread = new Thread(daemon);
            thread.setDaemon(true);
            return thread;
          }));
      assertTrue(refused.getMessage().startsWith("no master of ROS answers at http://127.0.0.1:1 ("),
          refused.getMessage());
    }
  }
}
