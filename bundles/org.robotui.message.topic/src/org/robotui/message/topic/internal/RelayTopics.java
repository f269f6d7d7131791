package org.robotui.message.topic.internal;

import java.nio.ByteOrder;
import java.time.Duration;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.robotui.api.port.CommandSink;
import org.robotui.data.Stamp;
import org.robotui.data.command.Motion;
import org.robotui.data.command.RelayMessage;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.CommandType;
import org.robotui.message.data.DataMessages;
import org.robotui.message.data.MessageByNames;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicGraph;
import org.robotui.message.topic.TopicSettings;

/**
 * Says on topics of this robot what other robots say. A topic is advertised with the first value and given up when none
 * came for a while, unless its last message is kept for those who subscribe later.
 */
public final class RelayTopics implements CommandSink<RelayMessage>, AutoCloseable {
  private static final Duration IDLE = Duration.ofMinutes(1);

  private record Relay(PatientTopic<DynamicMessage> topic, MessageByNames messages, TypeAgreement agreement,
      String type, boolean kept) {
    /** Says it as it came, where the other robot has the same type in the same encoding. */
    boolean saysRaw(RelayMessage said) {
      return said.original().type().equals(type) && said.original().wire()
          .filter(wire -> agreement.with(wire)
              && topic.sayRaw(wire.encoding(), wire.bytes().buffer(ByteOrder.LITTLE_ENDIAN)))
          .isPresent();
    }
  }

  private static final int MOST_WAITING = 64;

  private final ThreadPoolExecutor worker;
  private final TopicClient client;
  private final TopicSettings settings;
  private final DataMessages ofData = new DataMessages();
  private final Set<String> relayed;
  private final Map<String, Relay> relays = new HashMap<>();
  private volatile TopicGraph graph = new TopicGraph(Map.of(), Map.of());

  /**
   * Has no topics yet.
   *
   * @param scope what ports share; is told which topics are relayed
   */
  public RelayTopics(TopicScope scope) {
    this.client = scope.client();
    this.settings = scope.settings();
    this.relayed = scope.relayed();
    this.worker = new ThreadPoolExecutor(1, 1, IDLE.toSeconds(), TimeUnit.SECONDS,
        new ArrayBlockingQueue<>(MOST_WAITING), scope.context().threads());
    worker.allowCoreThreadTimeOut(true);
  }

  /**
   * Takes note of who says and listens to what.
   *
   * @param seen who publishes and subscribes what
   */
  public void follow(TopicGraph seen) {
    graph = seen;
  }

  /** A stop must not wait behind a picture that becomes a message: only what commands is said on this thread. */
  @Override
  public Sent send(RelayMessage said) {
    return said.guarded() ? answered(said) : later(said);
  }

  private Sent later(RelayMessage said) {
    try {
      worker.execute(() -> answered(said));
      return new Sent.Out();
    } catch (RejectedExecutionException e) {
      String reason = "messages come faster than they can be said: " + MOST_WAITING + " wait";
      said.answer().told(Optional.of(reason));
      return new Sent.Refused(reason);
    }
  }

  private Sent answered(RelayMessage said) {
    Sent sent = said(said);
    said.answer().told(sent instanceof Sent.Refused refused ? Optional.of(refused.reason()) : Optional.empty());
    return sent;
  }

  private synchronized Sent said(RelayMessage said) {
    if (worker.isShutdown()) {
      return new Sent.Refused("the connection is being closed");
    }
    String topic = settings.topic(said.topic());
    Optional<String> type = type(topic, said);
    if (type.isEmpty()) {
      return new Sent.Refused("no message of this robot carries " + said.value().getClass().getSimpleName()
          + " by itself: give the bridge the type of " + topic + " with 'type', and its fields with 'fields'");
    }
    return obstacle(topic, type.get(), said.guarded()).<Sent>map(Sent.Refused::new)
        .orElseGet(() -> say(topic, type.get(), said));
  }

  /** What others say or hear there has a type; else that of the original, else the usual one. */
  private Optional<String> type(String topic, RelayMessage said) {
    if (!said.type().isEmpty()) {
      return Optional.of(said.type());
    }
    return there(topic).or(() -> Optional.ofNullable(relays.get(topic)).map(Relay::type))
        .or(() -> Optional.of(said.original().type()).filter(this::isKnown))
        .or(() -> said.value() instanceof DynamicRecord record ? Optional.of(record.schema()).filter(this::isKnown)
            : ofData.usualType(said.value()));
  }

  private Optional<String> there(String topic) {
    TopicGraph now = graph;
    return Optional.ofNullable(now.subscribed().get(topic)).or(() -> Optional.ofNullable(now.published().get(topic)));
  }

  private boolean isKnown(String type) {
    return type.indexOf('/') > 0 && client.canCarry(type) && client.schema(type) instanceof SchemaLookup.Found;
  }

  private Optional<String> obstacle(String topic, String type, boolean guarded) {
    Optional<String> other = there(topic).filter(t -> !t.equals(type));
    if (other.isPresent()) {
      return Optional.of(topic + " carries " + other.get() + ", not " + type);
    }
    Optional<CommandType<?, ?>> command = CommandType.of(type)
        .filter(c -> !c.named() || settings.commands().getOrDefault(type, List.of()).stream()
            .anyMatch(name -> settings.topic(name).equals(topic)));
    if (command.filter(c -> Motion.class.isAssignableFrom(c.data())).isPresent()) {
      return Optional.of(topic + " moves the robot; it is commanded by its own port, which is there while somebody"
          + " subscribes to it or 'velocity' of the robot interface names it");
    }
    return guarded ? Optional.empty()
        : command.map(c -> topic + " commands the robot (" + c.help() + "); bridge with 'lease: true'");
  }

  private Sent say(String topic, String type, RelayMessage said) {
    Relay relay = relays.get(topic);
    if (relay == null || !relay.type().equals(type) || relay.kept() != said.kept()) {
      if (!(client.schema(type) instanceof SchemaLookup.Found<MessageSchema> found)) {
        return new Sent.Refused("the definition of " + type + " is not known here");
      }
      relay = advertised(topic, type, found.schema(), said.kept());
    }
    if (!relay.kept() && !relay.topic().isHeard()) {
      relay.topic().used();
      return relay.topic().obstacle().<Sent>map(Sent.Refused::new).orElseGet(Sent.Out::new);
    }
    if (relay.saysRaw(said)) {
      return new Sent.Out();
    }
    try {
      Optional<DynamicRecord> record = record(type, said);
      if (record.isEmpty()) {
        return new Sent.Refused(type + " does not carry " + said.value().getClass().getSimpleName()
            + " by itself: give the bridge its 'fields'");
      }
      relay.topic().say(relay.messages().of(record.get()));
      return new Sent.Out();
    } catch (IllegalArgumentException e) {
      return new Sent.Refused(String.valueOf(e.getMessage()));
    }
  }

  private Relay advertised(String topic, String type, MessageSchema schema, boolean kept) {
    Optional.ofNullable(relays.remove(topic)).ifPresent(old -> old.topic().close());
    Relay made =
        new Relay(new PatientTopic<>(client.relayed(topic, schema, kept)), new MessageByNames(schema),
            new TypeAgreement(schema), type, kept);
    relays.put(topic, made);
    relayed.add(topic);
    return made;
  }

  private Optional<DynamicRecord> record(String type, RelayMessage said) {
    Optional<DynamicRecord> original =
        said.original().type().equals(type) ? said.original().record().get() : Optional.empty();
    return original.or(() -> said.value() instanceof DynamicRecord record ? Optional.of(record)
        : ofData.message(said.value(), type, said.stamp().map(Stamp::nanos).orElse(0L)));
  }

  /** Says what waited for its listeners, and gives up what is not used. */
  public synchronized void tick() {
    for (Iterator<Relay> all = relays.values().iterator(); all.hasNext();) {
      Relay relay = all.next();
      relay.topic().tick();
      if (!relay.kept() && relay.topic().idleNanos() > IDLE.toNanos()) {
        all.remove();
        relay.topic().close();
      }
    }
  }

  @Override
  public void close() {
    worker.shutdownNow();
    closeAll();
  }

  private synchronized void closeAll() {
    relays.values().forEach(relay -> relay.topic().close());
    relays.clear();
  }
}
