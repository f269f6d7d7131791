package org.robotui.rfic.roboframe.internal.session;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.Generation;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageSchema;
import org.robotui.message.RecordCodec;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.MessageForm;
import org.robotui.message.payload.PayloadFormats;
import org.robotui.message.payload.ReceptionRule;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicListener;
import org.robotui.message.topic.TopicPublisher;
import org.robotui.message.topic.TopicSubscription;
import org.robotui.roboframe.link.BrokerLink;
import org.robotui.roboframe.wire.BoardKey;
import org.robotui.roboframe.wire.BrokerMessage;

/** The keys of an application as topics. What we use ourselves is said to the application as it changes. */
final class RoboframeTopics implements TopicClient {
  static final String NAME = "robotui";
  private static final long MILLION = 1_000_000;

  private final BrokerLink link;
  private final PayloadFormats formats;
  private final List<KeyReception<?>> receptions = new CopyOnWriteArrayList<>();
  private final List<KeyPublisher<?>> publishers = new CopyOnWriteArrayList<>();
  private volatile RemoteBoard board = RemoteBoard.EMPTY;

  RoboframeTopics(BrokerLink link, PayloadFormats formats) {
    this.link = link;
    this.formats = formats;
  }

  /** Takes note of what the application uses now. */
  synchronized void follow(List<BoardKey> keys) {
    board = board.with(keys, formats);
    receptions.forEach(each -> each.follow(board));
    say();
    publishers.forEach(this::follow);
  }

  private void follow(KeyPublisher<?> publisher) {
    publisher.follow(board.read(ReceptionRule.global(publisher.key().name())));
  }

  RemoteBoard board() {
    return board;
  }

  /** A value has come; on the reading thread. */
  void received(BrokerMessage.Value value) {
    long now = System.nanoTime();
    String topic = ReceptionRule.global(value.key());
    receptions.stream().filter(each -> each.topic().equals(topic)).forEach(each -> each.received(value, now));
  }

  /** Says which keys we use: each as the application writes it, and as we write it. */
  private void say() {
    Map<String, BoardKey> own = new LinkedHashMap<>();
    receptions.forEach(each -> each.wanted().ifPresent(wanted -> {
      BoardKey key = wanted.key();
      own.put(key.name(), new BoardKey(key.name(), key.type(), key.sum(), key.definition(), List.of(),
          List.of(NAME)));
    }));
    List<BoardKey> all = new ArrayList<>(own.values());
    publishers.forEach(each -> all.add(each.key()));
    link.say(all);
  }

  @Override
  public boolean isDefined(String topic) {
    return board.first(topic).map(each -> each.format().definition().isPresent()).orElse(true);
  }

  /** Each key carries the definition of its type. */
  @Override
  public boolean canCarry(String type) {
    return true;
  }

  @Override
  public synchronized <M> TopicSubscription subscribe(String topic, String type, MessageForm<M> form,
      TopicListener<M> listener) {
    KeyReception<M> reception =
        new KeyReception<>(new ReceptionRule<>(topic, type, form), listener, link.application().orElse(""), this::end);
    reception.follow(board);
    receptions.add(reception);
    say();
    return reception;
  }

  private synchronized void end(KeyReception<?> reception) {
    if (receptions.remove(reception)) {
      say();
    }
  }

  @Override
  public <M extends Record> TopicPublisher<M> commands(String topic, String type, Class<M> form, int mostWaiting) {
    return advertised(topic, RecordCodec.of(form), KeyPublisher.Manner.COMMAND);
  }

  @Override
  public TopicPublisher<DynamicMessage> messages(String topic, MessageSchema schema) {
    return advertised(topic, new DynamicCodec(schema), KeyPublisher.Manner.MESSAGE);
  }

  @Override
  public TopicPublisher<DynamicMessage> relayed(String topic, MessageSchema schema, boolean kept) {
    return advertised(topic, new DynamicCodec(schema),
        kept ? KeyPublisher.Manner.KEPT : KeyPublisher.Manner.MESSAGE);
  }

  private synchronized <M> TopicPublisher<M> advertised(String topic, MessageCodec<M> codec,
      KeyPublisher.Manner manner) {
    KeyPublisher<M> publisher = new KeyPublisher<>(link, topic.substring(1), codec, manner, this::end);
    publishers.add(publisher);
    say();
    follow(publisher);
    return publisher;
  }

  private synchronized void end(KeyPublisher<?> publisher) {
    if (publishers.remove(publisher)) {
      say();
    }
  }

  @Override
  public SchemaLookup<MessageSchema> schema(String type) {
    return board.all().flatMap(each -> each.format().definition().stream())
        .filter(each -> each.definition().type().equals(type)).findFirst()
        .<SchemaLookup<MessageSchema>>map(SchemaLookup.Found::new)
        .orElseGet(() -> formats.definitions().of(type, Generation.ROS1));
  }

  @Override
  public Optional<String> failure(String topic) {
    return board.written(topic).flatMap(each -> each.format().obstacle())
        .or(() -> receptions.stream().filter(each -> each.topic().equals(topic)).map(KeyReception::failure)
            .filter(reason -> !reason.isEmpty()).findFirst());
  }

  @Override
  public boolean isSimulated() {
    return false;
  }

  @Override
  public long nowNanos() {
    return System.currentTimeMillis() * MILLION;
  }

  @Override
  public String name() {
    return NAME;
  }
}
