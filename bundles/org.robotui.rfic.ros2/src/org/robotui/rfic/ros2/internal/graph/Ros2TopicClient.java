package org.robotui.rfic.ros2.internal.graph;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.port.RawDefinition;
import org.robotui.data.array.Bytes;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Encoding;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageForm;
import org.robotui.message.data.MessageRecord;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.message.ros.visualization_msgs.GetInteractiveMarkersResponse;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.RecordedDefinitions;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.rfic.ros2.internal.convert.TypeLookups;
import org.robotui.rfic.ros2.internal.convert.VersionedReading;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Clock;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Reception;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.graph.GraphState;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Qos;

/** The topics of ROS 2, through a node. */
final class Ros2TopicClient implements TopicClient {
  /** As values name it that were received; what was received is relayed by the same name. */
  static final String ENCODING = "cdr";
  /** What waits for subscribers that are slow for a moment. */
  private static final int MOST_RELAYED = 100;

  private final Ros2Node node;
  private final TypeLookups lookups;
  private final MarkerRequests markers;
  private final Map<String, TopicIn<?>> subscribed = new ConcurrentHashMap<>();
  private volatile Optional<GraphState> graph = Optional.empty();

  Ros2TopicClient(Ros2Node node, TypeLookups lookups) {
    this.node = node;
    this.lookups = lookups;
    this.markers = new MarkerRequests(node);
  }

  @Override
  public <M> TopicSubscription subscribe(String topic, String type, MessageForm<M> form, TopicListener<M> listener) {
    TypeName name = name(type);
    VersionedReading<M> reading = new VersionedReading<>(name, form, lookups);
    TopicIn<M> made = new TopicIn<>(node, topic, reading, () -> announced(topic, name),
        Ros2Codec.raw(name, Optional.empty()),
        (bytes, reception) -> received(topic, bytes, reception, reading, listener),
        ended -> subscribed.remove(topic, ended));
    subscribed.put(topic, made);
    made.advance();
    return made;
  }

  private static TypeName name(String type) {
    return TypeName.parse(type, TypeName.Kind.MSG)
        .orElseThrow(() -> new IllegalArgumentException("'" + type + "' is no name of a type"));
  }

  /** Takes note of who is there, and subscribes to what waits for its type. */
  void seen(GraphState state) {
    graph = Optional.of(state);
    subscribed.values().forEach(TopicIn::advance);
  }

  /** The version that a publisher of a topic announces; none where nobody is there that announces one. */
  private Optional<TypeHash> announced(String topic, TypeName type) {
    return publishers(topic).filter(end -> end.type().filter(type::equals).isPresent())
        .map(GraphEnd::hash).flatMap(Optional::stream).findFirst();
  }

  private Stream<GraphEnd> publishers(String topic) {
    return graph.flatMap(state -> Ros2Name.parse(topic).flatMap(state::topic)).stream()
        .flatMap(seen -> seen.publishers().stream());
  }

  private <M> void received(String topic, ByteBuffer bytes, Ros2Reception reception, VersionedReading<M> reading,
      TopicListener<M> listener) {
    Arrival arrival = new Arrival(reception.from(), reception.receiveNanos(), reception.kept(), ENCODING, bytes,
        raw -> record(reception.type(), reception.hash(), raw), topic,
        () -> definition(reception.type(), reception.hash()));
    M message;
    try {
      message = reading.read(bytes.duplicate(), reception.hash());
    } catch (MessageException e) {
      listener.unreadable(String.valueOf(e.getMessage()), arrival);
      return;
    }
    listener.received(message, arrival);
  }

  private Optional<RawDefinition> definition(TypeName type, Optional<TypeHash> hash) {
    return lookups.known(type, hash) instanceof SchemaLookup.Found<MessageSchema> found
        ? Optional.of(RecordedDefinitions.of(found.schema(), Encoding.CDR))
        : Optional.empty();
  }

  private Optional<DynamicRecord> record(TypeName type, Optional<TypeHash> hash, Bytes raw) {
    if (!(lookups.known(type, hash) instanceof SchemaLookup.Found<MessageSchema> found)) {
      return Optional.empty();
    }
    try {
      return Optional
          .of(new MessageRecord(Ros2Codec.of(type, found.schema()).decode(raw.buffer(ByteOrder.LITTLE_ENDIAN))));
    } catch (MessageException e) {
      return Optional.empty();
    }
  }

  @Override
  public <M extends Record> TopicPublisher<M> commands(String topic, String type, Class<M> form, int mostWaiting) {
    return new TopicOut<>(
        node.publisher(topic, Ros2Codec.of(form), QosProfiles.COMMANDS.withDepth(mostWaiting)));
  }

  @Override
  public TopicPublisher<DynamicMessage> messages(String topic, MessageSchema schema) {
    return new TopicOut<>(
        node.publisher(topic, Ros2Codec.of(name(schema.definition().type()), schema), Qos.reliable(1)));
  }

  @Override
  public TopicPublisher<DynamicMessage> relayed(String topic, MessageSchema schema, boolean kept) {
    Ros2Codec<DynamicMessage> codec = Ros2Codec.of(name(schema.definition().type()), schema);
    return new RelayedOut(new TopicOut<>(node.publisher(topic, Ros2Codec.raw(codec.type(), codec.hash()),
        kept ? QosProfiles.LATCHED : QosProfiles.DEFAULT.withDepth(MOST_RELAYED))), codec);
  }

  @Override
  public SchemaLookup<MessageSchema> schema(String type) {
    return lookups.known(name(type), Optional.empty());
  }

  @Override
  public Optional<String> failure(String topic) {
    return Optional.ofNullable(subscribed.get(topic)).flatMap(TopicIn::failure);
  }

  @Override
  public String delivery(String topic) {
    return publishers(topic).map(end -> QosProfiles.sentence(end.qos())).distinct().collect(Collectors.joining("; "));
  }

  @Override
  public boolean requestMarkers(String server, Consumer<GetInteractiveMarkersResponse> answer) {
    markers.ask(server, answer);
    return true;
  }

  /** A clock that nobody has set yet is none. */
  @Override
  public boolean isSimulated() {
    return node.clock().isSimulated() && node.clock().nowNanos() != 0;
  }

  @Override
  public long nowNanos() {
    Ros2Clock clock = node.clock();
    long now = clock.nowNanos();
    return now != 0 ? now : System.currentTimeMillis() * 1_000_000L;
  }

  @Override
  public String name() {
    return node.name().text();
  }
}
