package org.robotui.rfic.recording.internal;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.PayloadSource;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingWriter;
import org.robotui.recording.WriterOptions;

/** Writes recordings of messages of ROS 2; times are seconds from a begin. */
public final class SmallRecording implements AutoCloseable {
  public static final String ODOMETRY = "nav_msgs/msg/Odometry";
  static final long BEGIN = 1_700_000_000_000_000_000L;
  private static final PayloadFormats FORMATS = new PayloadFormats(new RosDefinitions(Map.of()));

  private final RecordingWriter writer;
  private ByteBuffer last = ByteBuffer.allocate(0);
  private final Map<String, RecordedChannel> channels = new HashMap<>();
  private final Map<String, PayloadFormat> formats = new HashMap<>();

  public SmallRecording(Path file) throws RecordingException {
    writer = RecordingWriter.create(file, WriterOptions.defaults().withChunkBytes(2000));
  }

  static long time(double seconds) {
    return BEGIN + Math.round(seconds * 1e9);
  }

  public SmallRecording odometry(String topic, double seconds, double x) throws RecordingException {
    return say(topic, ODOMETRY, Map.of(), seconds, odometry(seconds, x));
  }

  static Map<String, Object> odometry(double seconds, double x) {
    return Map.of("header", header(seconds, "odom"), "child_frame_id", "base_link", "pose",
        Map.of("pose", Map.of("position", Map.of("x", x), "orientation", Map.of("w", 1))));
  }

  SmallRecording transform(String topic, double seconds, String parent, String child, double x)
      throws RecordingException {
    return say(topic, "tf2_msgs/msg/TFMessage", Map.of(), seconds, Map.of("transforms", List.of(
        Map.of("header", header(seconds, parent), "child_frame_id", child, "transform",
            Map.of("translation", Map.of("x", x), "rotation", Map.of("w", 1))))));
  }

  public static Map<String, Object> header(double seconds, String frame) {
    long nanos = time(seconds);
    return Map.of("stamp", Map.of("sec", nanos / 1_000_000_000L, "nanosec", nanos % 1_000_000_000L), "frame_id", frame);
  }

  public SmallRecording say(String topic, String type, Map<String, String> metadata, double seconds,
      Map<String, Object> fields) throws RecordingException {
    PayloadFormat format = formats.computeIfAbsent(type, t -> FORMATS.of(new PayloadSource("cdr", t, "", "")));
    String definition = format.definition().orElseThrow().info().definition();
    RecordedChannel channel = channels.get(topic);
    if (channel == null) {
      channel = writer.channel(topic, "cdr",
          new RecordedSchema(type, "ros2msg", definition.getBytes(StandardCharsets.UTF_8)), metadata);
      channels.put(topic, channel);
    }
    last = format.write(fields);
    return again(topic, seconds);
  }

  /** The bytes of the last message once more. */
  SmallRecording again(String topic, double seconds) throws RecordingException {
    return at(topic, time(seconds));
  }

  /** The same at any time. */
  SmallRecording at(String topic, long nanos) throws RecordingException {
    writer.write(channels.get(topic), nanos, nanos, 0, last.duplicate());
    return this;
  }

  public SmallRecording raw(String topic, String encoding, double seconds, byte[] bytes) throws RecordingException {
    RecordedChannel channel = channels.get(topic);
    if (channel == null) {
      channel = writer.channel(topic, encoding, RecordedSchema.NONE, Map.of());
      channels.put(topic, channel);
    }
    writer.write(channel, time(seconds), time(seconds), 0, ByteBuffer.wrap(bytes));
    return this;
  }

  @Override
  public void close() throws RecordingException {
    writer.close();
  }
}
