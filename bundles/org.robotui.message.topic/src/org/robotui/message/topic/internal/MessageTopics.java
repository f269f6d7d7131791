package org.robotui.message.topic.internal;

import java.time.Duration;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.CommandSink;
import org.robotui.data.command.MessageCommand;
import org.robotui.data.command.Motion;
import org.robotui.message.DynamicCodec;
import org.robotui.message.MessageException;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.CommandType;
import org.robotui.message.topic.TopicClient;
import org.robotui.message.topic.TopicGraph;

/**
 * Says single messages of any type on any topic that somebody listens to. A topic is advertised with its first message,
 * which waits a moment for its listeners to connect, and is given up when nothing was said for a while. Nothing
 * latches: what was said is not said again to those who come later.
 */
public final class MessageTopics implements CommandSink<MessageCommand>, AutoCloseable {
  private static final Duration IDLE = Duration.ofSeconds(30);

  private final TopicClient client;
  private final Map<String, SaidTopic<?>> topics = new HashMap<>();
  private volatile Map<String, String> listened = Map.of();

  /**
   * Has no topics yet.
   *
   * @param client says what is to be said
   */
  public MessageTopics(TopicClient client) {
    this.client = client;
  }

  /**
   * Takes note of who listens to what.
   *
   * @param graph who subscribes what
   */
  public void follow(TopicGraph graph) {
    Map<String, String> heard = new HashMap<>(client.knowsListeners() ? Map.of() : graph.published());
    heard.putAll(graph.subscribed());
    listened = Map.copyOf(heard);
  }

  @Override
  public synchronized Sent send(MessageCommand command) {
    Optional<String> obstacle = obstacle(command);
    return obstacle.<Sent>map(Sent.Refused::new).orElseGet(() -> say(command));
  }

  private Optional<String> obstacle(MessageCommand command) {
    String expected = listened.getOrDefault(command.topic(), "");
    if (expected.isEmpty()) {
      return Optional.of("nobody subscribes to " + command.topic());
    }
    String meant = client.commandType(expected);
    if (!meant.equals(client.commandType(command.type()))) {
      return Optional.of(command.topic() + " carries " + expected + ", not " + command.type());
    }
    boolean moves = CommandType.of(meant).filter(c -> Motion.class.isAssignableFrom(c.data())).isPresent();
    return moves
        ? Optional.of(command.topic() + " moves the robot; drive it with a view that limits and ends the motion")
        : Optional.empty();
  }

  private Sent say(MessageCommand command) {
    Optional<SaidTopic<?>> topic =
        Optional.<SaidTopic<?>>ofNullable(topics.get(command.topic())).or(() -> topic(command));
    if (topic.isEmpty()) {
      return new Sent.Refused("the definition of " + command.type() + " is not known here");
    }
    topics.put(command.topic(), topic.get());
    if (!client.knowsListeners() && !topic.get().topic().isHeard()) {
      return new Sent.Refused("nobody subscribes to " + command.topic());
    }
    try {
      topic.get().say(command.fields());
      return new Sent.Out();
    } catch (MessageException | IllegalArgumentException e) {
      return new Sent.Refused(command.type() + " is not filled in like this: " + e.getMessage());
    }
  }

  private Optional<SaidTopic<?>> topic(MessageCommand command) {
    return client.fields(command.topic(), command.type())
        .<SaidTopic<?>>map(each -> new SaidTopic<>(new PatientTopic<>(each.opening().get()), each.encoding()::apply))
        .or(() -> defined(command));
  }

  private Optional<SaidTopic<?>> defined(MessageCommand command) {
    if (!(client.schema(command.type()) instanceof SchemaLookup.Found<MessageSchema> found)) {
      return Optional.empty();
    }
    return Optional.of(new SaidTopic<>(new PatientTopic<>(client.messages(command.topic(), found.schema())),
        new DynamicCodec(found.schema())::build));
  }

  /** Says what waited for its listeners, and gives up what is not used. */
  public synchronized void tick() {
    for (Iterator<SaidTopic<?>> all = topics.values().iterator(); all.hasNext();) {
      PatientTopic<?> topic = all.next().topic();
      topic.tick();
      if (topic.idleNanos() > IDLE.toNanos()) {
        all.remove();
        topic.close();
      }
    }
  }

  @Override
  public synchronized void close() {
    topics.values().forEach(said -> said.topic().close());
    topics.clear();
  }
}
