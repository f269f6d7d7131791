package org.robotui.rfic.foxglove.internal.session;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.robotui.api.port.RawDefinition;
import org.robotui.data.array.Bytes;
import org.robotui.foxglove.FoxgloveClient;
import org.robotui.foxglove.ServerChannel;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.message.payload.ReceptionRule;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.rfic.foxglove.internal.session.ChannelTable.Offered;
import org.robotui.web.ArrivalSubscription;

/**
 * A topic that is received, from all channels that carry it, as they come and go.
 *
 * @param <M> the Java value of a message
 */
final class TopicReception<M> implements TopicSubscription {
  /** Encodings of schemas that come in Base64. */
  private static final Set<String> BINARY = Set.of("protobuf", "flatbuffer");

  private final FoxgloveClient client;
  private final Wanted<M> wanted;
  private final Consumer<TopicReception<M>> end;
  private final Map<ServerChannel, ArrivalSubscription> channels = new HashMap<>();
  private String failure = "";
  private long dropped;

  /**
   * What is received.
   *
   * @param rule which channels carry it, and how they are read
   * @param sender who is said to have published what comes
   * @param listener is told
   * @param <M> the Java value of a message
   */
  record Wanted<M>(ReceptionRule<M> rule, String sender, TopicListener<M> listener) {}

  TopicReception(FoxgloveClient client, Wanted<M> wanted, Consumer<TopicReception<M>> end) {
    this.client = client;
    this.wanted = wanted;
    this.end = end;
  }

  String topic() {
    return wanted.rule().topic();
  }

  /** Receives from those channels that there are now. */
  synchronized void follow(ChannelTable table) {
    List<Offered> now = channels(table);
    List<ServerChannel> present = now.stream().map(Offered::channel).toList();
    List.copyOf(channels.keySet()).stream().filter(each -> !present.contains(each))
        .forEach(each -> leave(channels.remove(each)));
    failure = "";
    for (Offered each : now) {
      try {
        if (!channels.containsKey(each.channel())) {
          channels.put(each.channel(), subscribe(each));
        }
      } catch (IllegalArgumentException e) {
        failure = wanted.rule().topic() + ": " + e.getMessage();
      }
    }
  }

  private List<Offered> channels(ChannelTable table) {
    return table.all()
        .filter(each -> wanted.rule().takes(ReceptionRule.global(each.channel().topic()), each.format())).toList();
  }

  private ArrivalSubscription subscribe(Offered offered) {
    PayloadFormat.Reading<M> reading = wanted.rule().reading(offered.format());
    return client.subscribe(offered.channel(), wanted.rule().mostWaiting(),
        (payload, nanos, receivedNanos) -> received(offered, reading, payload, receivedNanos));
  }

  private void received(Offered offered, PayloadFormat.Reading<M> reading, ByteBuffer payload, long receivedNanos) {
    Arrival arrival = new Arrival(wanted.sender(), receivedNanos, false, offered.channel().encoding(),
        payload.asReadOnlyBuffer(), offered.format()::record, offered.channel().topic(),
        () -> definition(offered.channel()));
    M message;
    try {
      message = reading.read(payload);
    } catch (IllegalArgumentException e) {
      wanted.listener().unreadable(String.valueOf(e.getMessage()), arrival);
      return;
    }
    wanted.listener().received(message, arrival);
  }

  private static Optional<RawDefinition> definition(ServerChannel channel) {
    if (channel.schema().isEmpty()) {
      return Optional.empty();
    }
    try {
      byte[] content = BINARY.contains(channel.schemaEncoding()) ? Base64.getDecoder().decode(channel.schema())
          : channel.schema().getBytes(StandardCharsets.UTF_8);
      return Optional.of(new RawDefinition(channel.type(), schemaEncoding(channel), Bytes.of(content)));
    } catch (IllegalArgumentException e) {
      return Optional.empty(); // no Base64, which was told when its messages were to be read
    }
  }

  /** Servers of the first versions of the protocol did not name it. */
  private static String schemaEncoding(ServerChannel channel) {
    return !channel.schemaEncoding().isEmpty() ? channel.schemaEncoding() : switch (channel.encoding()) {
      case "ros1" -> "ros1msg";
      case "cdr" -> "ros2msg";
      case "json" -> "jsonschema";
      default -> channel.encoding();
    };
  }

  /** Why nothing comes, empty where nothing is known to be wrong. */
  synchronized String failure() {
    return failure;
  }

  @Override
  public synchronized int publishers() {
    return channels.size();
  }

  /** Of what only the newest counts, nothing is lost where it gives way to a newer one. */
  @Override
  public synchronized Lost lost() {
    channels.values().forEach(each -> dropped += each.dropped());
    return wanted.rule().mostWaiting() == 1 || dropped == 0 ? Lost.NONE
        : new Lost(dropped, wanted.rule().topic() + ": more came than could be taken");
  }

  private void leave(ArrivalSubscription channel) {
    dropped += channel.dropped();
    channel.close();
  }

  @Override
  public void close() {
    synchronized (this) {
      channels.values().forEach(this::leave);
      channels.clear();
    }
    end.accept(this);
  }
}
