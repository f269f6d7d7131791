package org.robotui.recorder.internal.file;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.RawDefinition;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.RawOrigin;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.Recordings;
import org.robotui.recording.ScanProgress;
import org.robotui.testkit.host.FakeExchange;
import org.robotui.testkit.host.FakeRuic;

/** A robot that sends what a test wants, and what a recording has of it. */
final class RecordedRobot {
  static final long STAMP = 1_234_567_890_123_456_789L;

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  final FakeRuic ruic;

  RecordedRobot(String name, String... ports) {
    ruic = new FakeRuic(name).exchanging(wanted -> new FakeExchange(),
        new InterfaceConfig("base", "ros2", name, "", Map.of()));
    ruic.component(new ComponentStatus("base", "ros2", ComponentStatus.Kind.RFIC, RuicState.INITIALIZED, "",
        Optional.empty()));
    ruic.offering(List.of(ports).stream().map(RecordedRobot::status).toArray(PortStatus[]::new));
    for (String port : ports) {
      ruic.ports().offer("base", new StreamPort<>(port, DynamicRecord.class, Arity.MANY, ""));
    }
  }

  private static PortStatus status(String port) {
    return new PortStatus(new SourceId("base", port), PortKind.STREAM, "DynamicRecord", false, 0, 0, Double.NaN, false,
        0, "", "");
  }

  static SourceId id(String port) {
    return new SourceId("base", port);
  }

  static RawMessage raw(String topic, boolean kept, String content) {
    return raw(topic, "/node", kept, content);
  }

  static RawMessage raw(String topic, String sender, boolean kept, String content) {
    return new RawMessage("std_msgs/String", "cdr", bytes(content), RawMessage.Reader.NONE,
        new RawOrigin(topic, sender, kept,
            () -> Optional.of(new RawDefinition("std_msgs/msg/String", "ros2msg", bytes("string data\n")))));
  }

  private static Bytes bytes(String text) {
    return Bytes.of(text.getBytes(StandardCharsets.UTF_8));
  }

  static MapRecord value(String text) {
    return new MapRecord("Text", Map.of("data", new FieldValue.Text(text)));
  }

  /** A message of the robot. */
  void says(String port, String topic, boolean kept, String content) {
    says(port, raw(topic, kept, content));
  }

  void says(String port, RawMessage raw) {
    ruic.ports().put(id(port), value("?"), Optional.of(new Stamp(STAMP, ClockKind.ROBOT)), Optional.of(raw));
  }

  static void await(BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new AssertionError("it did not come to that within " + PATIENCE);
      }
      Thread.sleep(5);
    }
  }

  static RecordingReader open(Path file) throws Exception {
    return Recordings.open(file, ScanProgress.NONE);
  }

  /** The messages of a topic. */
  static List<RecordedMessage> messages(RecordingReader recording, String topic) throws Exception {
    List<RecordedMessage> messages = new ArrayList<>();
    RecordingCursor cursor = recording.cursor(RecordingInterval.ALWAYS, Set.of());
    for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
      next.filter(message -> message.channel().topic().equals(topic)).ifPresent(messages::add);
    }
    return messages;
  }

  static List<String> texts(Path file, String topic) throws Exception {
    try (RecordingReader recording = open(file)) {
      return messages(recording, topic).stream().map(RecordedRobot::text).toList();
    }
  }

  static String text(RecordedMessage message) {
    return StandardCharsets.UTF_8.decode(message.data().duplicate()).toString();
  }
}
