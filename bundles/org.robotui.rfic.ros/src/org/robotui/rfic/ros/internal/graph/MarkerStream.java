package org.robotui.rfic.ros.internal.graph;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.link.Pulse;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.message.RecordCodec;
import org.robotui.message.data.FrameNames;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerInit;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerUpdate;
import org.robotui.rfic.ros.internal.RosSettings;
import org.robotui.ros.Reception;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;

/**
 * The interactive markers of the servers on one topic as a stream: what the updates and the list of all say together.
 */
final class MarkerStream implements Followed {
  static final String TYPE = "visualization_msgs/InteractiveMarkerUpdate";
  private static final String UPDATE = "/update";
  private static final long SILENCE_NANOS = Duration.ofSeconds(10).toNanos();
  private static final int MOST_SERVERS = 16;

  private final String topic;
  private final RosNode node;
  private final SessionClock clock;
  private final LinkWatch watch;
  private final Pulse pulse;
  private final MarkerFeedbacks feedbacks;
  private final Publication<InteractiveMarkerSet> publication;
  private final Map<String, MarkerSync> servers = new HashMap<>(); // guarded by this
  private final List<Subscriber> subscribers = new ArrayList<>();
  private boolean published = true;
  private boolean begun; // guarded by this
  private String told = "";
  private volatile long heardAt;
  private volatile boolean wanted;

  MarkerStream(
      String topic,
      RficContext context,
      RosSettings settings,
      RosNode node,
      SessionClock clock,
      LinkWatch watch,
      Pulse pulse,
      MarkerFeedbacks feedbacks) {
    this.topic = topic;
    this.node = node;
    this.clock = clock;
    this.watch = watch;
    this.pulse = pulse;
    this.feedbacks = feedbacks;
    StreamPort<InteractiveMarkerSet> port = new StreamPort<>(
        settings.portName(topic), InteractiveMarkerSet.class, Arity.MANY, topic + ", interactive markers");
    this.publication = context.offers().stream(port, w -> wanted = w);
  }

  static boolean serves(String topic, String type) {
    return TYPE.equals(type) && topic.endsWith(UPDATE);
  }

  private String base() {
    return topic.substring(0, topic.length() - UPDATE.length());
  }

  private String feedback() {
    return base() + "/feedback";
  }

  @Override
  public String topic() {
    return topic;
  }

  @Override
  public String type() {
    return TYPE;
  }

  @Override
  public boolean wanted() {
    return wanted;
  }

  @Override
  public boolean flowing() {
    return subscribers.stream().anyMatch(s -> s.numPublishers() > 0);
  }

  @Override
  public void applyDemand() {
    if (wanted && subscribers.isEmpty()) {
      heardAt = System.nanoTime();
      feedbacks.open(feedback());
      SubscriberOptions options = SubscriberOptions.observing();
      subscribers.add(node.subscriber(topic, RecordCodec.of(InteractiveMarkerUpdate.class), options, this::updated));
      subscribers.add(
          node.subscriber(base() + "/update_full", RecordCodec.of(InteractiveMarkerInit.class), options, this::begun));
    } else if (!wanted) {
      end();
    }
  }

  private synchronized void updated(InteractiveMarkerUpdate message, Reception reception) {
    heardAt = reception.receiveNanos();
    pulse.heard(heardAt);
    FrameNames names = clock.names();
    server(message.serverId()).ifPresent(server -> say(server.take(message, names), reception));
  }

  private synchronized void begun(InteractiveMarkerInit message, Reception reception) {
    FrameNames names = clock.names();
    server(message.serverId()).ifPresent(server -> say(server.take(message, names), reception));
  }

  private Optional<MarkerSync> server(String id) {
    if (servers.size() >= MOST_SERVERS && !servers.containsKey(id)) {
      publication.lost(1, topic + ": more than " + MOST_SERVERS + " servers; " + id + " is left out");
      return Optional.empty();
    }
    return Optional.of(servers.computeIfAbsent(id,
        i -> new MarkerSync(feedback(), complaint -> publication.lost(1, topic + " from " + i + ": " + complaint))));
  }

  /** The first that is said counts as all there is: what was known from before may be gone. */
  private void say(List<InteractiveMarkerSet.Entry> changed, Reception reception) {
    boolean first = !begun && servers.values().stream().anyMatch(MarkerSync::synchronised);
    if (first || !changed.isEmpty()) {
      begun = true;
      publication.publish(new InteractiveMarkerSet(first, changed), Optional.empty(), reception.receiveNanos(),
          Optional.empty());
    }
  }

  @Override
  public void published(boolean now) {
    published = now;
    String problem = problem();
    if (!problem.isEmpty() || !told.isEmpty()) {
      publication.failed(problem);
    }
    told = problem;
  }

  @Override
  public String problem() {
    if (!wanted) {
      return "";
    }
    if (!published) {
      return "nobody publishes " + topic + " any more";
    }
    boolean silent = !subscribers.isEmpty() && System.nanoTime() - heardAt > SILENCE_NANOS;
    return watch.failure(topic).orElse(silent ? "no sign of life on " + topic + " for 10 s" : "");
  }

  private void end() {
    if (!subscribers.isEmpty()) {
      subscribers.forEach(Subscriber::close);
      subscribers.clear();
      feedbacks.close(feedback());
      watch.forget(topic);
      forget();
    }
  }

  private synchronized void forget() {
    servers.clear();
    begun = false;
  }

  @Override
  public void close() {
    end();
    publication.close();
  }
}
