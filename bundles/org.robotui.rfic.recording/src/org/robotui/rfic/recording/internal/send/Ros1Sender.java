package org.robotui.rfic.recording.internal.send;

import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import org.robotui.message.MessageInfo;
import org.robotui.message.RawCodec;
import org.robotui.message.RawMessage;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.rosgraph_msgs.Clock;
import org.robotui.net.call.Outcome;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.rfic.recording.internal.file.Ros1Types;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.SystemState;

/** Publishes into a graph of ROS 1, as {@code rosbag play} does. */
final class Ros1Sender implements FrameworkSender {
  static final String ENCODING = "ros1";
  private static final String CLOCK = "/clock";
  private static final String SENDER = "callerid";
  private static final Duration PATIENCE = Duration.ofSeconds(5);

  /** Channels of one topic are one publisher; a node has one type for each topic. */
  private record Sent(MessageInfo info, boolean latched) {}

  private final RosNode node;
  private final Map<String, MessageInfo> infos = new HashMap<>();
  private final Map<String, Publisher<RawMessage>> publishers = new HashMap<>();
  private final Optional<Publisher<Clock>> time;

  private Ros1Sender(RosNode node, Map<String, Sent> topics, boolean clock) {
    this.node = node;
    topics.forEach((topic, sent) -> {
      infos.put(topic, sent.info());
      publishers.put(topic, node.publisher(topic, new RawCodec(sent.info()),
          sent.latched() ? PublisherOptions.latched() : PublisherOptions.standard()));
    });
    time = clock ? Optional.of(node.publisher(CLOCK, RecordCodec.of(Clock.class), PublisherOptions.standard()))
        : Optional.empty();
  }

  /** Announces all topics at a master that is there. */
  static Ros1Sender open(List<RecordedChannel> channels, boolean clock, Map<String, String> variables,
      ThreadFactory threads) throws IOException {
    Map<String, Sent> topics = topics(channels, clock);
    RosEnvironment environment = RosEnvironment.of(variables, List.of());
    RosNode node = RosNode.open(environment, GraphName.anonymous("robotui_play"), NodeOptions.standard(threads));
    try {
      Outcome<SystemState> there = node.master().systemState();
      Ros1Sender sender = new Ros1Sender(node, topics, clock);
      if (!(there instanceof Outcome.Done) || !node.awaitRegistered(PATIENCE)) {
        throw new IOException("no master of ROS answers at " + environment.masterUri() + " (" + there.reason()
            + "): start one (roscore), or name the one that is there by ROS_MASTER_URI");
      }
      return sender;
    } catch (IOException | RuntimeException e) {
      node.close();
      throw e;
    }
  }

  private static Map<String, Sent> topics(List<RecordedChannel> channels, boolean clock) throws IOException {
    Map<String, Sent> topics = new HashMap<>();
    for (RecordedChannel each : channels) {
      String topic = name(each);
      if (clock && topic.equals(CLOCK)) {
        continue;
      }
      MessageInfo info = Ros1Types.of(each);
      Sent before = topics.get(topic);
      if (before != null && !before.info().md5().equals(info.md5())) {
        throw new IOException(topic + " has messages of two types, " + before.info().type() + " and " + info.type()
            + ", which a topic of ROS cannot have: choose others by --topics");
      }
      topics.put(topic, new Sent(info, each.isLatched() || before != null && before.latched()));
    }
    return topics;
  }

  private static String name(RecordedChannel channel) {
    return channel.topic().startsWith("/") ? channel.topic() : "/" + channel.topic();
  }

  @Override
  public void send(RecordedMessage message) {
    String topic = name(message.channel());
    Publisher<RawMessage> publisher = publishers.get(topic);
    if (publisher != null) {
      publisher.publish(new RawMessage(infos.get(topic), message.data()), holder(message.channel()));
    }
  }

  /** A topic may have several senders that latch, and others that do not. */
  private static Optional<String> holder(RecordedChannel channel) {
    return Optional.of(channel.metadata().getOrDefault(SENDER, "")).filter(sender -> channel.isLatched());
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
    node.close();
  }
}
