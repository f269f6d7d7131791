package org.robotui.rfic.recording.internal.send;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import org.robotui.message.DefinitionException;
import org.robotui.message.Generation;
import org.robotui.message.MessageSchema;
import org.robotui.message.description.TypeDescription;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.message.ros.rosgraph_msgs.Clock;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Options;
import org.robotui.ros2.Ros2Publisher;
import org.robotui.rtps.Durability;
import org.robotui.rtps.Qos;

/** Publishes into a graph of ROS 2, as {@code ros2 bag play} does. */
final class Ros2Sender implements FrameworkSender {
  static final String ENCODING = "cdr";
  private static final String CLOCK = "/clock";
  private static final int DEPTH = 100;
  private static final Duration PATIENCE = Duration.ofSeconds(2);

  private final Ros2Context context;
  private final Map<Integer, Ros2Publisher<ByteBuffer>> publishers = new HashMap<>();
  private final Optional<Ros2Publisher<Clock>> time;

  private Ros2Sender(Ros2Context context, List<RecordedChannel> channels, boolean clock) throws IOException {
    this.context = context;
    Ros2Node node = context.node("robotui_play");
    for (RecordedChannel each : channels) {
      if (!clock || !each.topic().equals(CLOCK)) {
        publishers.put(each.id(), node.publisher(each.topic(), codec(each), qos(each)));
      }
    }
    time = clock ? Optional.of(node.publisher(CLOCK, Ros2Codec.of(Clock.class), QosProfiles.CLOCK)) : Optional.empty();
  }

  /** Announces all topics in the domain that the environment names. */
  static Ros2Sender open(List<RecordedChannel> channels, boolean clock, Map<String, String> variables,
      ThreadFactory threads) throws IOException {
    Ros2Context context =
        Ros2Context.open(Ros2Environment.of(variables, List.of()), Ros2Options.standard(threads));
    try {
      return new Ros2Sender(context, channels, clock);
    } catch (IOException | RuntimeException e) {
      context.close();
      throw e;
    }
  }

  private static Ros2Codec<ByteBuffer> codec(RecordedChannel channel) throws IOException {
    String name = channel.schema().name();
    TypeName type = TypeName.parse(name, TypeName.Kind.MSG)
        .orElseThrow(() -> new IOException(channel.topic() + ": '" + name
            + "' is no type of ROS 2, such as sensor_msgs/msg/Imu: choose other topics by --topics"));
    return Ros2Codec.raw(type, hash(type, channel));
  }

  /** Peers match without it; with it they see that definitions are the same. */
  private static Optional<TypeHash> hash(TypeName type, RecordedChannel channel) {
    if (!channel.schema().encoding().equals("ros2msg")) {
      return Optional.empty();
    }
    try {
      MessageSchema schema = MessageSchema.parse(channel.schema().name(),
          new String(channel.schema().definition(), StandardCharsets.UTF_8), Generation.ROS2);
      return Optional.of(TypeDescription.of(type, schema).hash());
    } catch (DefinitionException e) {
      return Optional.empty();
    }
  }

  /** Reliable, so that whoever listens is served; what holds is kept for late ones. */
  private static Qos qos(RecordedChannel channel) {
    return channel.isLatched() ? Qos.reliable(DEPTH).with(Durability.TRANSIENT_LOCAL) : Qos.reliable(DEPTH);
  }

  @Override
  public void send(RecordedMessage message) {
    Ros2Publisher<ByteBuffer> publisher = publishers.get(message.channel().id());
    if (publisher != null) {
      publisher.publish(FrameworkSender.copy(message.data()));
    }
  }

  @Override
  public void clock(long nanos) {
    time.ifPresent(publisher -> publisher.publish(new Clock(nanos)));
  }

  @Override
  public boolean isHeard() {
    return publishers.values().stream().allMatch(each -> each.numSubscribers() > 0);
  }

  @Override
  public void finish() {
    publishers.values().forEach(each -> each.awaitSent(PATIENCE));
  }

  @Override
  public void close() {
    context.close();
  }
}
