package org.robotui.rfic.recording.internal.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.robotui.message.Generation;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.ReceptionRule;
import org.robotui.message.topic.TopicGraph;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordingReader;
import org.robotui.rfic.recording.internal.file.ChannelFormats;

/** The channels of a recording by topic; several may have the same. Immutable. */
public final class TopicTable {
  private final Map<String, List<PlayedChannel>> byTopic = new TreeMap<>();

  /**
   * Finds out how all of them are read.
   *
   * @param recording the recording
   * @param formats knows encodings
   */
  TopicTable(RecordingReader recording, PayloadFormats formats) {
    ChannelFormats known = new ChannelFormats(formats);
    Map<Integer, Long> counts = recording.messageCounts();
    for (RecordedChannel channel : recording.channels()) {
      String topic = name(channel);
      byTopic.computeIfAbsent(topic, name -> new ArrayList<>())
          .add(new PlayedChannel(channel, topic, known.of(channel), counts.getOrDefault(channel.id(), 0L)));
    }
  }

  /**
   * The topics.
   *
   * @return their names, sorted
   */
  public Set<String> topics() {
    return byTopic.keySet();
  }

  /**
   * The channels of a topic.
   *
   * @param topic its name
   * @return empty where there is none
   */
  public List<PlayedChannel> of(String topic) {
    return byTopic.getOrDefault(topic, List.of());
  }

  /**
   * The channel that stands for a topic.
   *
   * @param topic its name
   * @return the first one
   */
  public Optional<PlayedChannel> first(String topic) {
    return of(topic).stream().findFirst();
  }

  /** The name of the topic of a channel as robot interfaces have it. */
  static String name(RecordedChannel channel) {
    return ReceptionRule.global(channel.topic());
  }

  /** Whether topics lie below a name. */
  boolean isNamespace(String name) {
    return byTopic.keySet().stream().anyMatch(topic -> topic.startsWith("/" + name + "/"));
  }

  /** All channels. */
  Stream<PlayedChannel> all() {
    return byTopic.values().stream().flatMap(List::stream);
  }

  /** Whose definitions its messages have. */
  Generation generation() {
    return all().anyMatch(each -> each.channel().messageEncoding().equals("ros1")) ? Generation.ROS1 : Generation.ROS2;
  }

  /** All is published for ever, and nobody takes anything. */
  TopicGraph graph() {
    Map<String, String> published = new TreeMap<>();
    byTopic.forEach((topic, channels) -> published.put(topic, channels.getFirst().format().type()));
    return new TopicGraph(published, Map.of());
  }
}
