package org.robotui.rfic.recording.internal.send;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.message.description.TypeName;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingPart;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.Recordings;
import org.robotui.recording.ScanProgress;
import org.robotui.rfic.recording.internal.SmallRecording;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Options;
import org.robotui.ros2.Ros2SubscriberOptions;

/** Recordings of ROS 2 reach a node of ROS 2 as they are. */
class Ros2SenderTest {
  private static final int DOMAIN = 201 + (int) (ProcessHandle.current().pid() % 14);
  private static final RecordingPart ALL = new RecordingPart(RecordingInterval.ALWAYS, channel -> true);
  private static final ThreadFactory DAEMONS = task -> {
    Thread thread = new Thread(task);
    thread.setDaemon(true);
    return thread;
  };

  @TempDir
  private Path folder;

  @Test
  void messagesArriveByteForByte() throws Exception {
    Path file = folder.resolve("run.mcap");
    try (SmallRecording writer = new SmallRecording(file)) {
      writer.say("/start", SmallRecording.ODOMETRY,
          Map.of("offered_qos_profiles", "- history: 1\n  durability: 1\n"), 0, Map.of("child_frame_id", "start"));
      writer.odometry("/odom", 0.1, 1);
    }
    BlockingQueue<ByteBuffer> starts = new LinkedBlockingQueue<>();
    BlockingQueue<ByteBuffer> places = new LinkedBlockingQueue<>();
    Map<String, String> variables = Map.of("ROS_DOMAIN_ID", Integer.toString(DOMAIN));
    try (RecordingReader recording = Recordings.open(file, ScanProgress.NONE);
        Ros2Context context = Ros2Context.open(Ros2Environment.local(DOMAIN), Ros2Options.standard(DAEMONS));
        Ros2Node node = context.node("listener");
        RecordingSender sender = RecordingSender.open(recording, ALL, false, variables, DAEMONS)) {
      Ros2Codec<ByteBuffer> codec = Ros2Codec.raw(TypeName.parse(SmallRecording.ODOMETRY).orElseThrow(),
          Optional.empty());
      node.subscriber("/start", codec, Ros2SubscriberOptions.of(QosProfiles.LATCHED),
          (message, reception) -> starts.add(message));
      node.subscriber("/odom", codec, Ros2SubscriberOptions.of(QosProfiles.DEFAULT),
          (message, reception) -> places.add(message));
      Thread sending = DAEMONS.newThread(() -> {
        try {
          sender.send(new SendPace(1, true, Duration.ZERO, true));
        } catch (IOException e) {
          throw new AssertionError(e);
        }
      });
      sending.start();
      ByteBuffer place = places.poll(30, TimeUnit.SECONDS);
      ByteBuffer start = starts.poll(30, TimeUnit.SECONDS);
      sending.interrupt();
      sending.join();
      assertEquals(recorded(recording, "/odom"), place);
      assertEquals(recorded(recording, "/start"), start);
    }
  }

  private static ByteBuffer recorded(RecordingReader recording, String topic) throws IOException {
    int channel = recording.channels().stream().filter(each -> each.topic().equals(topic)).findFirst().orElseThrow()
        .id();
    return recording.latestBefore(channel, Long.MAX_VALUE).map(RecordedMessage::data).orElseThrow();
  }

  @Test
  void whatHasNoTypeOfRos2IsNamed() throws Exception {
    Path file = folder.resolve("odd.mcap");
    try (SmallRecording writer = new SmallRecording(file)) {
      writer.raw("/odd", "cdr", 1, new byte[]{0, 1, 0, 0});
    }
    try (RecordingReader recording = Recordings.open(file, ScanProgress.NONE)) {
      IOException refused = assertThrows(IOException.class, () -> RecordingSender.open(recording, ALL, false,
          Map.of("ROS_DOMAIN_ID", Integer.toString(DOMAIN)), DAEMONS));
      assertTrue(refused.getMessage().startsWith("/odd: '' is no type of ROS 2"), refused.getMessage());
    }
  }
}
