package org.robotui.message.topic.internal;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.robotui.data.command.Motion;
import org.robotui.message.data.Adapters;
import org.robotui.message.data.CommandType;
import org.robotui.message.topic.TopicGraph;
import org.robotui.message.topic.TopicPorts;

/** Keeps the offered ports equal to the graph. Used by the one thread that follows the graph, but for closing. */
public final class TopicOffers implements AutoCloseable {
  private static final Set<String> TRANSFORMS = Set.of("tf", "tf_static");
  private static final Set<String> OWN =
      Set.of(TopicPorts.PUBLISH.name(), TopicPorts.RELAY.name(), TopicPorts.MARKER_FEEDBACK.name());

  private final TopicScope scope;
  private final Adapters adapters = new Adapters();
  private final MarkerFeedbacks feedbacks;
  private final Map<String, Followed> streams = new HashMap<>();
  private final Map<String, CommandTopic> commands = new HashMap<>();
  private volatile BaseTopics bases = BaseTopics.of(Map.of());
  private boolean closed;

  /**
   * Offers nothing yet.
   *
   * @param scope what ports share
   * @param feedbacks tells servers of interactive markers what users do
   */
  public TopicOffers(TopicScope scope, MarkerFeedbacks feedbacks) {
    this.scope = scope;
    this.feedbacks = feedbacks;
  }

  /**
   * Offers what there is now.
   *
   * @param graph who publishes and subscribes what
   */
  public synchronized void follow(TopicGraph graph) {
    if (closed) {
      return;
    }
    Map<String, String> taken = commandTopics(graph.subscribed());
    followStreams(withoutOrders(graph.published(), taken));
    followCommands(taken);
  }

  /** Subscribes to what is wanted, and to nothing else. */
  public synchronized void applyDemand() {
    streams.values().forEach(Followed::applyDemand);
  }

  /**
   * What is wanted but does not come.
   *
   * @return a sentence, empty where all is well
   */
  public synchronized String problem() {
    return streams.values().stream()
        .map(Followed::problem)
        .filter(p -> !p.isEmpty())
        .sorted()
        .collect(Collectors.joining("; "));
  }

  /**
   * Whether messages can come of anything that is wanted.
   *
   * @return true where a publisher is connected
   */
  public synchronized boolean flowing() {
    return streams.values().stream().anyMatch(Followed::flowing);
  }

  /**
   * Goals and initial poses that others give are no news of the robot: a view would take them for where it is.
   * Velocities that others command stay visible.
   */
  private static Map<String, String> withoutOrders(Map<String, String> published, Map<String, String> taken) {
    Map<String, String> news = new TreeMap<>(published);
    news.keySet().removeIf(t -> taken.containsKey(t)
        && CommandType.of(published.get(t)).filter(c -> !Motion.class.isAssignableFrom(c.data())).isPresent());
    return news;
  }

  /** A topic that somebody looks at stays when its publisher goes: it is missing, and may return. */
  private void followStreams(Map<String, String> published) {
    for (Iterator<Followed> i = streams.values().iterator(); i.hasNext();) {
      Followed stream = i.next();
      String type = published.getOrDefault(stream.topic(), "");
      boolean gone = type.isEmpty() && !stream.wanted() || !type.isEmpty() && !type.equals(stream.type());
      if (gone) {
        i.remove();
        stream.close();
      } else {
        stream.published(!type.isEmpty());
      }
    }
    published.forEach((topic, type) -> {
      boolean moves = TRANSFORMS.contains(scope.settings().portName(topic));
      if (scope.settings().offers(topic) && !moves && !streams.containsKey(topic)) {
        Followed made = stream(topic, type);
        streams.put(topic, made);
        made.published(true);
      }
    });
  }

  private Followed stream(String topic, String type) {
    return MarkerStream.serves(topic, type)
        ? new MarkerStream(topic, scope, feedbacks)
        : new TopicStream(topic, scope.client().isDefined(topic) ? adapters.of(type) : adapters.ofFields(type), scope);
  }

  private Map<String, String> commandTopics(Map<String, String> subscribed) {
    Map<String, String> topics = new HashMap<>();
    subscribed.forEach((topic, type) -> {
      // a topic that carries the name of a port for all topics would hide it
      boolean free = CommandType.of(type).filter(CommandType::named).isEmpty();
      if (free && scope.settings().offers(topic) && !OWN.contains(scope.settings().portName(topic))) {
        topics.put(topic, type);
      }
    });
    scope.settings().commands()
        .forEach((type, names) -> names.forEach(n -> topics.putIfAbsent(scope.settings().topic(n), type)));
    topics.values().removeIf(type -> CommandType.of(type).isEmpty());
    return topics;
  }

  private void followCommands(Map<String, String> topics) {
    bases = BaseTopics.of(topics);
    Set<String> gone = new HashSet<>(commands.keySet());
    gone.removeIf(t -> Objects.equals(topics.get(t), commands.get(t).type()));
    gone.forEach(t -> commands.remove(t).close());
    topics.forEach((topic, type) -> {
      if (!commands.containsKey(topic)) {
        CommandType.of(type).ifPresent(c -> commands.put(topic,
            new CommandTopic(topic, c, scope, () -> bases.test(topic))));
      }
    });
  }

  /** Stops what we drive, and offers nothing more. Blocks until that is sent, at most 0.3 s a topic. */
  public synchronized void stop() {
    closed = true;
    commands.values().forEach(CommandTopic::close);
    commands.clear();
  }

  @Override
  public synchronized void close() {
    stop();
    streams.values().forEach(Followed::close);
    streams.clear();
  }
}
