package org.robotui.rfic.recording.internal.send;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.net.call.Outcome;
import org.robotui.player.client.ClientOptions;
import org.robotui.player.client.DataListener;
import org.robotui.player.client.PlayerClient;
import org.robotui.player.interfaces.Laser;
import org.robotui.player.interfaces.Pose2d;
import org.robotui.player.interfaces.Position2d;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Layouts;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingPart;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.RecordingWriter;
import org.robotui.recording.Recordings;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.WriterOptions;
import org.robotui.rfic.recording.internal.file.RecordingFiles;

/** What clients of Player hear of a recording. */
class PlayerSenderTest {
  private static final int SECONDS = 60;
  private static final long BEGIN = 1_700_000_000_000_000_000L;
  private static final Map<String, String> FREE = Map.of("PLAYER_PORT", "0");
  private static final ThreadFactory THREADS = task -> {
    Thread thread = new Thread(task);
    thread.setDaemon(true);
    return thread;
  };
  private static final String LOG = """
      ## Player version 3.1.1-dev\s
      ## File version 0.3.0\s
      0000000025.070 16777343 6665 position2d 00 001 001 +00.339 -00.004 -0.122 +00.500 +00.000 +00.000 0
      0000000025.120 16777343 6665 laser 00 001 001 0000 -1.5708 +1.5708 +0.01745329 +8.0000 0002 5.845  0 6.183  1\s
      0000000025.130 16777343 6665 laser 00 004 001  +0.125  +0.000   0.000   0.156   0.155
      0000000025.140 16777343 6665 position2d 00 001 001 +00.349 -00.004 -0.122 +00.500 +00.000 +00.000 1
      """;

  @TempDir
  private Path folder;
  private final Layouts layouts = Layouts.standard();

  private static RecordingSender sender(RecordingReader recording, Map<String, String> variables) throws Exception {
    return RecordingSender.open(recording, new RecordingPart(RecordingInterval.ALWAYS, channel -> true), false,
        variables, THREADS);
  }

  private PlayerClient client(String place) {
    int port = Integer.parseInt(place.replaceAll(".*127\\.0\\.0\\.1:(\\d+) .*", "$1"));
    Duration patience = Duration.ofSeconds(SECONDS);
    return new PlayerClient("127.0.0.1", port, layouts,
        ClientOptions.standard(THREADS).withTimes(patience, patience, patience, Duration.ofMillis(200)));
  }

  private static <T> DataListener<T> into(BlockingQueue<T> queue) {
    return (value, stamp, receiveNanos) -> queue.add(value);
  }

  private static <T> T next(BlockingQueue<T> queue) throws InterruptedException {
    T value = queue.poll(SECONDS, TimeUnit.SECONDS);
    assertTrue(value != null, "nothing came");
    return value;
  }

  @Test
  void a_log_is_the_robot_of_which_it_was_written() throws Exception {
    Path log = Files.writeString(folder.resolve("run.log"), LOG);
    BlockingQueue<Position2d.State> states = new LinkedBlockingQueue<>();
    BlockingQueue<Laser.Scan> scans = new LinkedBlockingQueue<>();
    try (RecordingReader recording = RecordingFiles.openToSend(log, List.of(), ScanProgress.NONE);
        RecordingSender sender = sender(recording, FREE)) {
      assertTrue(sender.places().getFirst().endsWith(" with laser:0, position2d:0"), sender.places().toString());
      try (PlayerClient client = client(sender.places().getFirst())) {
        client.device("position2d", 0).subscribe(Position2d.STATE, into(states));
        client.device("laser", 0).subscribe(Laser.SCAN, into(scans));
        assertEquals(4, sender.send(new SendPace(10, false, Duration.ZERO, true)));
        assertEquals(0.339, next(states).position().x(), 1e-6);
        Position2d.State last = next(states);
        assertTrue(last.stall(), last.toString());
        assertEquals(6.183, next(scans).ranges()[1], 1e-6);
        Outcome<?> geometry = client.device("laser", 0).request(Laser.GET_GEOMETRY, new Empty()).get(SECONDS,
            TimeUnit.SECONDS);
        assertTrue(geometry instanceof Outcome.Done && geometry.toString().contains("0.125"), geometry.toString());
        Outcome<?> refused = client.device("position2d", 0).request(Position2d.RESET_ODOMETRY, new Empty())
            .get(SECONDS, TimeUnit.SECONDS);
        assertTrue(refused instanceof Outcome.Refused, refused.toString());
      }
    }
  }

  @Test
  void each_recorded_robot_has_a_server() throws Exception {
    Path file = folder.resolve("run.mcap");
    try (RecordingWriter writer = RecordingWriter.create(file, WriterOptions.defaults())) {
      for (int robot = 1; robot <= 2; robot++) {
        ByteBuffer state = layouts.codec(Position2d.STATE)
            .encode(new Position2d.State(new Pose2d(robot, 0, 0), new Pose2d(0, 0, 0), false));
        writer.write(writer.channel("position2d:0", "player", new RecordedSchema("position2d/state", "player",
            new byte[]{1}), Map.of("callerid", "robot" + robot + ":6665")), BEGIN + robot, BEGIN, 0, state);
      }
    }
    BlockingQueue<Position2d.State> states = new LinkedBlockingQueue<>();
    try (RecordingReader recording = Recordings.open(file, ScanProgress.NONE);
        RecordingSender sender = sender(recording, FREE);
        PlayerClient first = client(sender.places().getFirst());
        PlayerClient second = client(sender.places().getLast())) {
      first.device("position2d", 0).subscribe(Position2d.STATE, into(new LinkedBlockingQueue<>()));
      second.device("position2d", 0).subscribe(Position2d.STATE, into(states));
      sender.send(new SendPace(1, false, Duration.ZERO, true));
      assertEquals(2, next(states).position().x(), 1e-9);
    }
  }

  @Test
  void a_place_where_nothing_can_listen_is_named() throws Exception {
    Path log = Files.writeString(folder.resolve("run.log"), LOG);
    try (RecordingReader recording = RecordingFiles.openToSend(log, List.of(), ScanProgress.NONE)) {
      String word = assertThrows(IOException.class, () -> sender(recording, Map.of("PLAYER_PORT", "70000")))
          .getMessage();
      assertEquals("PLAYER_PORT is '70000'; write a port from 1 to 65535, or 0 for a free one", word);
      String host = assertThrows(IOException.class,
          () -> sender(recording, Map.of("PLAYER_HOST", "192.0.2.1", "PLAYER_PORT", "0"))).getMessage();
      assertTrue(host.startsWith("no Player server can listen at 192.0.2.1:0 (") && host.contains("PLAYER_HOST"), host);
    }
  }
}
