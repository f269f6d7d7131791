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
  private final Map<String, PatientTopic> topics = new HashMap<>();
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
    listened = graph.subscribed();
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
    if (!expected.equals(command.type())) {
      return Optional.of(command.topic() + " carries " + expected + ", not " + command.type());
    }
    boolean moves = CommandType.of(expected).filter(c -> Motion.class.isAssignableFrom(c.data())).isPresent();
    return moves
        ? Optional.of(command.topic() + " moves the robot; drive it with a view that limits and ends the motion")
        : Optional.empty();
  }

  private Sent say(MessageCommand command) {
    if (!(client.schema(command.type()) instanceof SchemaLookup.Found<MessageSchema> found)) {
      return new Sent.Refused("the definition of " + command.type() + " is not known here");
    }
    DynamicCodec codec = new DynamicCodec(found.schema());
    try {
      topic(command, found.schema()).say(codec.build(command.fields()));
      return new Sent.Out();
    } catch (MessageException e) {
      return new Sent.Refused(command.type() + " is not filled in like this: " + e.getMessage());
    }
  }

  private PatientTopic topic(MessageCommand command, MessageSchema schema) {
    return topics.computeIfAbsent(command.topic(),
        t -> new PatientTopic(client.messages(t, schema)));
  }

  /** Says what waited for its listeners, and gives up what is not used. */
  public synchronized void tick() {
    for (Iterator<PatientTopic> all = topics.values().iterator(); all.hasNext();) {
      PatientTopic topic = all.next();
      topic.tick();
      if (topic.idleNanos() > IDLE.toNanos()) {
        all.remove();
        topic.close();
      }
    }
  }

  @Override
  public synchronized void close() {
    topics.values().forEach(PatientTopic::close);
    topics.clear();
  }
}
