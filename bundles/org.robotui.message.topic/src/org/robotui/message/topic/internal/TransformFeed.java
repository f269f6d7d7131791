package org.robotui.message.topic.internal;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Publication;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.StreamPort;
import org.robotui.data.geometry.TransformSet;
import org.robotui.message.data.FrameNames;
import org.robotui.message.data.MessageForm;
import org.robotui.message.data.StateAdapters;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.topic.Arrival;
import org.robotui.message.topic.SharedTransforms;
import org.robotui.message.topic.TopicGraph;
import org.robotui.message.topic.TopicSubscription;

/**
 * Transforms, moving and static. Of all interfaces that see the same topics one listens, and gives to each what
 * concerns its robot: an interface in a namespace is spared frames that begin with the name of another one. When the
 * one that listens ends, the next one does. A robot in a namespace may say transforms there, too: those are its own.
 * The old type {@code tf/tfMessage} has the same definition, and so the same sum, as the present one.
 */
public final class TransformFeed implements AutoCloseable {
  private static final String TYPE = "tf2_msgs/TFMessage";

  private final TopicScope scope;
  private final SharedTransforms shared;
  private final String namespace;
  private final Publication<TransformSet> publication;
  private final List<TopicSubscription> subscriptions = new ArrayList<>();
  private final Map<Boolean, TopicSubscription> own = new HashMap<>();
  private final HeldTransforms held = new HeldTransforms();
  private boolean closed;

  /**
   * Offers the transforms of a robot; it is listened to them at once, unless another interface does.
   *
   * @param scope what ports share
   * @param shared the interfaces that see the same topics
   */
  public TransformFeed(TopicScope scope, SharedTransforms shared) {
    this.scope = scope;
    this.shared = shared;
    this.namespace = scope.settings().namespace().substring(1).replaceAll("/$", "");
    this.publication = scope.context().offers().stream(
        new StreamPort<>("tf", TransformSet.class, Arity.MANY, "/tf and /tf_static"), Demand.IGNORED);
    publication.held(this::held);
    if (scope.settings().tf()) {
      shared.add(this);
      tick();
    } else {
      closed = true;
    }
  }

  /** Listens for all where nobody does. Called regularly by the thread that follows the graph. */
  public synchronized void tick() {
    if (!closed && subscriptions.isEmpty() && shared.listens(this)) {
      subscribe(false);
      subscribe(true);
    }
  }

  private void subscribe(boolean fixed) {
    subscriptions.add(subscribe(topic(fixed),
        (message, arrival) -> shared.heard(message, arrival.sender(), fixed, arrival.receiveNanos(), raw(arrival))));
  }

  private TopicSubscription subscribe(String topic, BiConsumer<TFMessage, Arrival> taking) {
    return scope.client().subscribe(topic, TYPE, new MessageForm.Bound<>(TFMessage.class, false),
        new TopicIntake<>(topic, publication, taking));
  }

  /**
   * Listens to the transforms in the robot's namespace while somebody says them.
   *
   * @param graph who publishes what
   */
  public synchronized void follow(TopicGraph graph) {
    if (!closed && !namespace.isEmpty()) {
      follow(graph, false);
      follow(graph, true);
    }
  }

  private void follow(TopicGraph graph, boolean fixed) {
    String topic = "/" + namespace + topic(fixed);
    if (!TYPE.equals(graph.published().get(topic))) {
      Optional.ofNullable(own.remove(fixed)).ifPresent(TopicSubscription::close);
    } else if (!own.containsKey(fixed)) {
      own.put(fixed, subscribe(topic, (message, arrival) -> receivedOwn(message, arrival, fixed)));
    }
  }

  private void receivedOwn(TFMessage message, Arrival arrival, boolean fixed) {
    Optional<RawMessage> raw = raw(arrival);
    if (fixed) {
      raw.ifPresent(came -> held.note(message, came));
    }
    received(message, arrival.sender(), fixed, arrival.receiveNanos(), raw);
  }

  /** Not all that says where things are comes as a message of its own. */
  private static Optional<RawMessage> raw(Arrival arrival) {
    return arrival.topic().isEmpty() ? Optional.empty() : Optional.of(arrival.raw(TYPE, arrival.reading()::apply));
  }

  private List<RawMessage> held() {
    return Stream.concat(shared.held(this::concerns).stream(), held.messages(child -> true).stream()).toList();
  }

  private static String topic(boolean fixed) {
    return fixed ? "/tf_static" : "/tf";
  }

  /**
   * The namespace of the robot.
   *
   * @return without slashes at its ends, empty for all
   */
  public String namespace() {
    return namespace;
  }

  /**
   * Takes what concerns its robot. On the thread of the one that listens.
   *
   * @param all what was said
   * @param sender who said it
   * @param fixed whether it holds for good
   * @param receiveNanos when it was received, {@link System#nanoTime()}
   * @param raw the message as it came, of all robots; none where it did not come as one
   */
  public void received(TFMessage all, String sender, boolean fixed, long receiveNanos, Optional<RawMessage> raw) {
    List<TransformStamped> own = all.transforms().stream().filter(t -> concerns(t.childFrameId())).toList();
    if (own.isEmpty()) {
      return;
    }
    TFMessage message = new TFMessage(own);
    FrameNames names = scope.clock().names();
    Optional<TransformSet> good = StateAdapters.transforms(message, names, fixed);
    int refused = own.size() - good.map(set -> set.transforms().size()).orElse(0);
    if (refused > 0) {
      publication.lost(refused, topic(fixed) + " from " + sender + ": " + refused + " of " + own.size()
          + " transforms refused; " + StateAdapters.refusal(message, names).orElse(""));
    }
    good.ifPresent(set -> {
      scope.context().frames().add(set, sender);
      publication.publish(set, scope.clock().stamp(set.transforms().getFirst().stamp().nanos(), names), receiveNanos,
          raw);
    });
  }

  private boolean concerns(String frame) {
    int from = frame.startsWith("/") ? 1 : 0;
    if (namespace.isEmpty() || frame.startsWith(namespace + "/", from)) {
      return true;
    }
    int end = frame.indexOf('/', from);
    return end < 0 || !isStranger(frame.substring(from, end));
  }

  private boolean isStranger(String prefix) {
    return !namespace.startsWith(prefix + "/") && shared.isNamespace(prefix);
  }

  @Override
  public synchronized void close() {
    closed = true;
    subscriptions.forEach(TopicSubscription::close);
    own.values().forEach(TopicSubscription::close);
    own.clear();
    shared.remove(this);
    publication.close();
  }
}
