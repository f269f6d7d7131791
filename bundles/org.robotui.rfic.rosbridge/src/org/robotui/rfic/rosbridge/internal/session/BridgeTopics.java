package org.robotui.rfic.rosbridge.internal.session;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.Adapters;
import org.robotui.message.data.MessageForm;
import org.robotui.message.payload.CommandFormat;
import org.robotui.message.payload.RosDefinitions;
import org.robotui.message.topic.PromptPublisher;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.rfic.rosbridge.internal.RosbridgeSettings;
import org.robotui.rosbridge.BridgePublisher;
import org.robotui.rosbridge.BridgeReceiver;
import org.robotui.rosbridge.RosbridgeClient;
import org.robotui.rosbridge.SubscriptionOptions;
import org.robotui.web.ArrivalSubscription;

/** The topics behind a bridge. Those that wait for their definition are followed by {@link #tick}. */
public final class BridgeTopics implements TopicClient {
  private static final String NAME = "robotui";

  private final RosbridgeClient client;
  private final RosApiWatch watch;
  private final RosDefinitions definitions;
  private final RosbridgeSettings settings;
  private final List<BridgeReception<?>> receptions = new CopyOnWriteArrayList<>();
  private final SimulatedTime time = new SimulatedTime();

  BridgeTopics(RosbridgeClient client, RosApiWatch watch, RosDefinitions definitions, RosbridgeSettings settings) {
    this.client = client;
    this.watch = watch;
    this.definitions = definitions;
    this.settings = settings;
  }

  void tick() {
    receptions.forEach(BridgeReception::tick);
    time.follow(this, watch.graph());
  }

  RosApiWatch watch() {
    return watch;
  }

  String server() {
    return settings.url().toString();
  }

  ArrivalSubscription receive(String topic, String type, int most, BridgeReceiver receiver) {
    return client.subscribe(topic, watch.graph().written(type),
        new SubscriptionOptions(most, settings.throttleMillis(), settings.compression()), receiver);
  }

  @Override
  public <M> TopicSubscription subscribe(String topic, String type, MessageForm<M> form, TopicListener<M> listener) {
    BridgeReception<M> reception = new BridgeReception<>(new BridgeReception.Asked<>(topic, type, form,
        new Adapters().mostWaiting(type, form), listener), this, receptions::remove);
    receptions.add(reception);
    reception.tick();
    return reception;
  }

  @Override
  public <M extends Record> TopicPublisher<M> commands(String topic, String type, Class<M> form, int mostWaiting) {
    return published(topic, type, commandFormat().trees(form, type));
  }

  @Override
  public TopicPublisher<DynamicMessage> messages(String topic, MessageSchema schema) {
    return published(topic, schema.definition().type(), commandFormat()::tree);
  }

  private <M> TopicPublisher<M> published(String topic, String type, Function<M, Map<String, Object>> tree) {
    BridgePublisher publisher = client.advertise(topic, watch.graph().written(type));
    return new PromptPublisher<>((message, patience) -> publisher.publish(tree.apply(message), patience),
        () -> listening(topic), publisher::close);
  }

  /**
   * How trees of messages are written for this ROS.
   *
   * @return the format
   */
  public CommandFormat commandFormat() {
    return new CommandFormat("json", watch.graph().generation(), definitions);
  }

  private int listening(String topic) {
    return client.link().whenEnded().isDone() ? 0 : watch.graph().ends(false).getOrDefault(topic, Set.of()).size();
  }

  @Override
  public SchemaLookup<MessageSchema> schema(String type) {
    return watch.schema(type).orElseGet(() -> definitions.of(type, watch.graph().generation()));
  }

  @Override
  public Optional<String> failure(String topic) {
    return receptions.stream().filter(each -> each.topic().equals(topic)).map(BridgeReception::failure)
        .filter(reason -> !reason.isEmpty()).findFirst();
  }

  @Override
  public boolean isSimulated() {
    return time.now().isPresent();
  }

  @Override
  public long nowNanos() {
    OptionalLong simulated = time.now();
    return simulated.orElseGet(() -> System.currentTimeMillis() * 1_000_000L);
  }

  @Override
  public String name() {
    return NAME;
  }
}
