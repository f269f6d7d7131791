package org.robotui.message.topic.internal;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.message.data.FrameNames;
import org.robotui.message.data.MessageForm;
import org.robotui.message.ros.visualization_msgs.GetInteractiveMarkersResponse;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerInit;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerUpdate;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.TopicSubscription;

/**
 * The interactive markers of the servers on one topic as a stream: what the updates and the list of all say together.
 */
final class MarkerStream implements Followed {
  static final String TYPE = "visualization_msgs/InteractiveMarkerUpdate";
  private static final String FULL = "visualization_msgs/InteractiveMarkerInit";
  private static final String UPDATE = "/update";
  private static final long SILENCE_NANOS = Duration.ofSeconds(10).toNanos();
  private static final long ASK_AGAIN_NANOS = Duration.ofSeconds(1).toNanos();
  private static final int MOST_SERVERS = 16;
  private static final String ONLY_SERVER = "";

  private final String topic;
  private final TopicScope scope;
  private final MarkerFeedbacks feedbacks;
  private final Publication<InteractiveMarkerSet> publication;
  private final Map<String, MarkerSync> servers = new HashMap<>(); // guarded by this
  private final List<TopicSubscription> subscriptions = new ArrayList<>();
  private boolean published = true;
  private boolean begun; // guarded by this
  private String told = "";
  private volatile boolean asksServer;
  private long askedAt;
  private volatile long heardAt;
  private volatile boolean wanted;

  MarkerStream(String topic, TopicScope scope, MarkerFeedbacks feedbacks) {
    this.topic = topic;
    this.scope = scope;
    this.feedbacks = feedbacks;
    StreamPort<InteractiveMarkerSet> port = new StreamPort<>(scope.settings().portName(topic),
        InteractiveMarkerSet.class, Arity.MANY, topic + ", interactive markers");
    this.publication = scope.context().offers().stream(port, w -> wanted = w);
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
    return subscriptions.stream().anyMatch(s -> s.publishers() > 0);
  }

  @Override
  public void applyDemand() {
    if (wanted && subscriptions.isEmpty()) {
      heardAt = System.nanoTime();
      feedbacks.open(feedback());
      subscriptions.add(subscribe(topic, TYPE, InteractiveMarkerUpdate.class, this::updated));
      ask();
      if (!asksServer) {
        subscriptions.add(subscribe(base() + "/update_full", FULL, InteractiveMarkerInit.class, this::begun));
      }
    } else if (!wanted) {
      end();
    } else if (asksServer && System.nanoTime() - askedAt > ASK_AGAIN_NANOS && !synchronised()) {
      ask();
    }
  }

  /** A server that is not there yet, or has lost one of its updates on the way to us, is asked again. */
  private void ask() {
    askedAt = System.nanoTime();
    asksServer = scope.client().requestMarkers(base(), this::answered);
  }

  private synchronized boolean synchronised() {
    return servers.containsKey(ONLY_SERVER) && servers.get(ONLY_SERVER).synchronised();
  }

  private synchronized void answered(GetInteractiveMarkersResponse all) {
    if (!wanted) {
      return;
    }
    heardAt = System.nanoTime();
    InteractiveMarkerInit init = new InteractiveMarkerInit(ONLY_SERVER, all.sequenceNumber(), all.markers());
    FrameNames names = scope.clock().names();
    server(ONLY_SERVER).ifPresent(server -> say(server.answered(init, names), heardAt));
  }

  private <M extends Record> TopicSubscription subscribe(String from, String type, Class<M> form,
      BiConsumer<M, Arrival> taking) {
    return scope.client().subscribe(from, type, new MessageForm.Bound<>(form, false),
        new TopicIntake<>(from, publication, taking));
  }

  private synchronized void updated(InteractiveMarkerUpdate message, Arrival arrival) {
    heardAt = arrival.receiveNanos();
    scope.pulse().heard(heardAt);
    FrameNames names = scope.clock().names();
    server(asksServer ? ONLY_SERVER : message.serverId())
        .ifPresent(server -> say(server.take(message, names), arrival.receiveNanos()));
  }

  private synchronized void begun(InteractiveMarkerInit message, Arrival arrival) {
    FrameNames names = scope.clock().names();
    server(message.serverId()).ifPresent(server -> say(server.take(message, names), arrival.receiveNanos()));
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
  private void say(List<InteractiveMarkerSet.Entry> changed, long receiveNanos) {
    boolean first = !begun && servers.values().stream().anyMatch(MarkerSync::synchronised);
    if (first || !changed.isEmpty()) {
      begun = true;
      publication.publish(new InteractiveMarkerSet(first, changed), Optional.empty(), receiveNanos,
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
    boolean silent = !asksServer && !subscriptions.isEmpty() && System.nanoTime() - heardAt > SILENCE_NANOS;
    return scope.client().failure(topic).orElse(silent ? "no sign of life on " + topic + " for 10 s" : "");
  }

  private void end() {
    if (!subscriptions.isEmpty()) {
      subscriptions.forEach(TopicSubscription::close);
      subscriptions.clear();
      feedbacks.close(feedback());
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
