package org.robotui.rfic.foxglove.internal.session;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import org.robotui.foxglove.ClientChannel;
import org.robotui.foxglove.FoxgloveClient;
import org.robotui.foxglove.ServerInfo;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Generation;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageForm;
import org.robotui.message.topic.PromptPublisher;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.CommandFormat;
import org.robotui.message.payload.ReceptionRule;

/** The topics behind a server. Channels are followed by {@link #tick}, which one thread calls. */
public final class FoxgloveTopics implements TopicClient {
  private static final String NAME = "robotui";

  private final FoxgloveClient client;
  private final ServerNews news;
  private final PayloadFormats formats;
  private final String server;
  private final List<TopicReception<?>> receptions = new CopyOnWriteArrayList<>();
  private volatile ChannelTable table = ChannelTable.EMPTY;

  FoxgloveTopics(FoxgloveClient client, ServerNews news, PayloadFormats formats, String server) {
    this.client = client;
    this.news = news;
    this.formats = formats;
    this.server = server;
  }

  /** Takes note of other channels; answers whether there are any. */
  boolean tick() {
    boolean changed = news.takeOffers();
    if (changed) {
      table = table.with(client.channels(), formats);
      receptions.forEach(each -> each.follow(table));
    }
    return changed;
  }

  /**
   * The channels now.
   *
   * @return by topic
   */
  public ChannelTable table() {
    return table;
  }

  @Override
  public boolean isDefined(String topic) {
    return table.first(topic).map(each -> each.format().definition().isPresent()).orElse(true);
  }

  @Override
  public <M> TopicSubscription subscribe(String topic, String type, MessageForm<M> form, TopicListener<M> listener) {
    ReceptionRule<M> rule = new ReceptionRule<>(topic, type, form);
    TopicReception<M> reception = new TopicReception<>(client, new TopicReception.Wanted<>(rule, server, listener),
        receptions::remove);
    receptions.add(reception);
    reception.follow(table);
    return reception;
  }

  @Override
  public <M extends Record> TopicPublisher<M> commands(String topic, String type, Class<M> form, int mostWaiting) {
    return published(topic, type, format -> format.writing(form, type));
  }

  @Override
  public TopicPublisher<DynamicMessage> messages(String topic, MessageSchema schema) {
    return published(topic, schema.definition().type(), format -> format::write);
  }

  private <M> TopicPublisher<M> published(String topic, String type,
      Function<CommandFormat, CommandFormat.Writing<M>> writing) {
    Optional<CommandFormat> format = commandFormat();
    if (format.isEmpty()) {
      return PromptPublisher.unheard();
    }
    CommandFormat chosen = format.get();
    CommandFormat.Writing<M> written = writing.apply(chosen);
    ClientChannel channel = client.advertise(original(topic), chosen.encoding(), chosen.typeName(type),
        chosen.schemaEncoding(), chosen.schema(type));
    return new PromptPublisher<>((message, patience) -> channel.publish(written.write(message), patience),
        () -> listening(topic), channel::close);
  }

  /** How messages to the server are written; none where it takes none. */
  Optional<CommandFormat> commandFormat() {
    return client.info().filter(info -> info.can(ServerInfo.CLIENT_PUBLISH))
        .flatMap(info -> CommandFormat.of(info.encodings(), table.threeParts(), formats.definitions()));
  }

  /** As the server writes it. */
  private String original(String topic) {
    return table.first(topic).map(each -> each.channel().topic()).or(() -> news.ends()
        .flatMap(ends -> ends.subscribers().keySet().stream()
            .filter(each -> ReceptionRule.global(each).equals(topic)).findFirst()))
        .orElse(topic);
  }

  /** Where the server does not say who subscribes, it is itself the one who does. */
  private int listening(String topic) {
    return client.link().whenEnded().isDone() ? 0
        : subscribers().map(all -> all.getOrDefault(topic, Set.of()).size()).orElse(1);
  }

  /** Who else subscribes to what; none where the server does not say so. */
  Optional<Map<String, Set<String>>> subscribers() {
    return client.info().filter(info -> info.can(ServerInfo.CONNECTION_GRAPH))
        .map(info -> news.ends().map(ends -> ServerGraph.others(ends.subscribers(), info.name())).orElse(Map.of()));
  }

  @Override
  public SchemaLookup<MessageSchema> schema(String type) {
    Optional<MessageSchema> sent = table.all().flatMap(each -> each.format().definition().stream())
        .filter(each -> each.definition().type().equals(type)).findFirst();
    Generation generation = commandFormat().map(CommandFormat::generation).orElse(Generation.ROS1);
    return sent.<SchemaLookup<MessageSchema>>map(SchemaLookup.Found::new)
        .orElseGet(() -> formats.definitions().of(type, generation));
  }

  @Override
  public Optional<String> failure(String topic) {
    return table.of(topic).stream().flatMap(each -> each.format().obstacle().stream()).findFirst()
        .or(() -> receptions.stream().filter(each -> each.topic().equals(topic)).map(TopicReception::failure)
            .filter(reason -> !reason.isEmpty()).findFirst());
  }

  @Override
  public boolean isSimulated() {
    return news.time().isPresent();
  }

  @Override
  public long nowNanos() {
    return news.time().orElseGet(() -> System.currentTimeMillis() * 1_000_000L);
  }

  @Override
  public String name() {
    return NAME;
  }
}
