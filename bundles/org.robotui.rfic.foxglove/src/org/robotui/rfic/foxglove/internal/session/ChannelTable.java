package org.robotui.rfic.foxglove.internal.session;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.robotui.foxglove.ServerChannel;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.ReceptionRule;
import org.robotui.message.payload.RosDefinitions;

/**
 * The channels of a server by topic, at one moment. Several may have the same topic: programs that publish it have one
 * each. Topics begin with a slash here, also where the server's name does not.
 */
public final class ChannelTable {
  static final ChannelTable EMPTY = new ChannelTable(Map.of());

  private final Map<String, List<Offered>> byTopic;

  /**
   * A channel and how its messages are read.
   *
   * @param channel as the server offers it
   * @param format reads its messages
   */
  public record Offered(ServerChannel channel, PayloadFormat format) {}

  private ChannelTable(Map<String, List<Offered>> byTopic) {
    this.byTopic = byTopic;
  }

  /** The channels now; how those are read that were there before is not found out again. */
  ChannelTable with(List<ServerChannel> channels, PayloadFormats formats) {
    Map<ServerChannel, Offered> before = new HashMap<>();
    byTopic.values().forEach(all -> all.forEach(each -> before.put(each.channel(), each)));
    Map<String, List<Offered>> now = new TreeMap<>();
    channels.stream().sorted(Comparator.comparingLong(ServerChannel::id)).forEach(channel -> {
      Offered offered = Optional.ofNullable(before.get(channel))
          .orElseGet(() -> new Offered(channel, formats.of(ServerSource.of(channel))));
      now.computeIfAbsent(ReceptionRule.global(channel.topic()), topic -> new ArrayList<>()).add(offered);
    });
    return new ChannelTable(now);
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
  public List<Offered> of(String topic) {
    return byTopic.getOrDefault(topic, List.of());
  }

  /**
   * The channel that stands for a topic.
   *
   * @param topic its name
   * @return the first one
   */
  public Optional<Offered> first(String topic) {
    return of(topic).stream().findFirst();
  }

  /** All channels. */
  Stream<Offered> all() {
    return byTopic.values().stream().flatMap(List::stream);
  }

  /** Whether types of ROS have names of three parts here, as in ROS 2. */
  boolean threeParts() {
    return all().map(each -> each.channel().type()).anyMatch(RosDefinitions::isOfThreeParts);
  }
}
