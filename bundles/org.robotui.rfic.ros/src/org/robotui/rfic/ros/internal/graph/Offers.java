package org.robotui.rfic.ros.internal.graph;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.data.command.Motion;
import org.robotui.message.data.Adapters;
import org.robotui.message.data.CommandType;
import org.robotui.rfic.ros.internal.RosSettings;
import org.robotui.rfic.ros.internal.call.RosPorts;
import org.robotui.rfic.ros.internal.convert.RecordDecoder;
import org.robotui.ros.RosNode;

/** Keeps the offered ports equal to the graph. Used by the one thread that follows the graph, but for closing. */
final class Offers implements AutoCloseable {
  private static final Set<String> TRANSFORMS = Set.of("/tf", "/tf_static");
  private static final Set<String> OWN = Set.of(RosPorts.PUBLISH.name(), RosPorts.MARKER_FEEDBACK.name());

  private final RficContext context;
  private final RosSettings settings;
  private final RosNode node;
  private final SessionClock clock;
  private final Adapters adapters = new Adapters();
  private final RecordDecoder records;
  private final LinkWatch watch;
  private final Pulse pulse;
  private final MarkerFeedbacks feedbacks;
  private final Map<String, Followed> streams = new HashMap<>();
  private final Map<String, CommandTopic> commands = new HashMap<>();
  private volatile BaseTopics bases = BaseTopics.of(Map.of());
  private boolean closed;

  Offers(
      RficContext context,
      RosSettings settings,
      RosNode node,
      SessionClock clock,
      RecordDecoder records,
      LinkWatch watch,
      Pulse pulse,
      MarkerFeedbacks feedbacks) {
    this.context = context;
    this.settings = settings;
    this.node = node;
    this.clock = clock;
    this.records = records;
    this.watch = watch;
    this.pulse = pulse;
    this.feedbacks = feedbacks;
  }

  synchronized void follow(GraphSnapshot graph) {
    if (closed) {
      return;
    }
    Map<String, String> taken = commandTopics(graph.subscribed());
    followStreams(withoutOrders(graph.published(), taken));
    followCommands(taken);
  }

  /** Subscribes to what is wanted, and to nothing else. */
  synchronized void applyDemand() {
    streams.values().forEach(Followed::applyDemand);
  }

  /** What is wanted but does not come, empty where all is well. */
  synchronized String problem() {
    return streams.values().stream()
        .map(Followed::problem)
        .filter(p -> !p.isEmpty())
        .sorted()
        .collect(Collectors.joining("; "));
  }

  synchronized boolean flowing() {
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
      if (settings.offers(topic) && !TRANSFORMS.contains(topic) && !streams.containsKey(topic)) {
        streams.put(topic, stream(topic, type));
      }
    });
  }

  private Followed stream(String topic, String type) {
    return MarkerStream.serves(topic, type)
        ? new MarkerStream(topic, context, settings, node, clock, watch, pulse, feedbacks)
        : new TopicStream(topic, adapters.of(type), records, context, settings, node, clock, watch, pulse);
  }

  private Map<String, String> commandTopics(Map<String, String> subscribed) {
    Map<String, String> topics = new HashMap<>();
    subscribed.forEach((topic, type) -> {
      // a topic that carries the name of a port for all topics would hide it
      boolean free = CommandType.of(type).filter(CommandType::named).isEmpty();
      if (free && settings.offers(topic) && !OWN.contains(settings.portName(topic))) {
        topics.put(topic, type);
      }
    });
    settings.commands().forEach((type, names) -> names.forEach(n -> topics.putIfAbsent(settings.topic(n), type)));
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
            new CommandTopic(topic, c, context, settings, node, clock, pulse, () -> bases.test(topic))));
      }
    });
  }

  /** Stops what we drive, and offers nothing more. Blocks until that is sent, at most 0.3 s a topic. */
  synchronized void stop() {
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
