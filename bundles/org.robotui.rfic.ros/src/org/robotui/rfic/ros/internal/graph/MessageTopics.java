package org.robotui.rfic.ros.internal.graph;

import java.time.Duration;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.CommandSink;
import org.robotui.data.command.MessageCommand;
import org.robotui.data.command.Motion;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.data.CommandType;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;

/**
 * Says single messages of any type on any topic that somebody listens to. A topic is advertised with its first message,
 * which waits a moment for its listeners to connect, and is given up when nothing was said for a while. Nothing
 * latches: what was said is not said again to those who come later.
 */
final class MessageTopics implements CommandSink<MessageCommand>, AutoCloseable {
  private static final Duration PATIENCE = Duration.ofMillis(1500);
  private static final Duration GATHERING = Duration.ofMillis(150);
  private static final Duration IDLE = Duration.ofSeconds(30);

  private final RosNode node;
  private final MessageRegistry registry;
  private final Map<String, Topic> topics = new HashMap<>();
  private volatile Map<String, String> listened = Map.of();

  MessageTopics(RosNode node, MessageRegistry registry) {
    this.node = node;
    this.registry = registry;
  }

  /** Who listens to what. */
  void follow(GraphSnapshot graph) {
    listened = Map.copyOf(graph.subscribed());
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
    if (!(registry.message(command.type()) instanceof SchemaLookup.Found<MessageSchema> found)) {
      return new Sent.Refused("the definition of " + command.type() + " is not known here");
    }
    DynamicCodec codec = new DynamicCodec(found.schema());
    try {
      topic(command, codec).say(codec.build(command.fields()));
      return new Sent.Out();
    } catch (MessageException e) {
      return new Sent.Refused(command.type() + " is not filled in like this: " + e.getMessage());
    }
  }

  private Topic topic(MessageCommand command, DynamicCodec codec) {
    return topics.computeIfAbsent(command.topic(),
        t -> new Topic(node.publisher(t, codec, PublisherOptions.standard().withQueue(1))));
  }

  /** Says what waited for its listeners, and gives up what is not used. */
  synchronized void tick() {
    for (Iterator<Topic> all = topics.values().iterator(); all.hasNext();) {
      Topic topic = all.next();
      topic.tick();
      if (topic.idleNanos() > IDLE.toNanos()) {
        all.remove();
        topic.publisher.close();
      }
    }
  }

  @Override
  public synchronized void close() {
    topics.values().forEach(t -> t.publisher.close());
    topics.clear();
  }

  /** One advertised topic. */
  private static final class Topic {
    private final Publisher<DynamicMessage> publisher;
    private final long since = System.nanoTime();
    private Optional<DynamicMessage> waiting = Optional.empty();
    private long connectedAt;
    private long saidAt = since;
    private boolean ready;

    Topic(Publisher<DynamicMessage> publisher) {
      this.publisher = publisher;
    }

    void say(DynamicMessage message) {
      saidAt = System.nanoTime();
      if (ready) {
        publisher.publish(message);
      } else {
        waiting = Optional.of(message);
      }
    }

    /** The first listener is given some time for the others to come, so that all hear the first message. */
    void tick() {
      long now = System.nanoTime();
      if (!ready && connectedAt == 0 && publisher.numSubscribers() > 0) {
        connectedAt = now;
      }
      boolean gathered = connectedAt != 0 && now - connectedAt > GATHERING.toNanos();
      if (!ready && (gathered || now - since > PATIENCE.toNanos())) {
        ready = true;
        waiting.ifPresent(publisher::publish);
        waiting = Optional.empty();
      }
    }

    long idleNanos() {
      return System.nanoTime() - saidAt;
    }
  }
}
