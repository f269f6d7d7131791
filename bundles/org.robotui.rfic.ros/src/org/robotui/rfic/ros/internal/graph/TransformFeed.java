package org.robotui.rfic.ros.internal.graph;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.geometry.TransformSet;
import org.robotui.message.RecordCodec;
import org.robotui.message.data.FrameNames;
import org.robotui.message.data.StateAdapters;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.rfic.ros.internal.RosSettings;
import org.robotui.ros.Reception;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;

/**
 * Transforms, moving and static. Of all interfaces that speak to one master one listens, and gives to each what
 * concerns its robot: an interface in a namespace is spared frames that begin with the name of another one. When the
 * one that listens ends, the next one does. The old type {@code tf/tfMessage} has the same definition, and so the same
 * sum, as the present one.
 */
final class TransformFeed implements AutoCloseable {
  private final RficContext context;
  private final RosNode node;
  private final SessionClock clock;
  private final SharedMaster master;
  private final String namespace;
  private final Publication<TransformSet> publication;
  private final List<Subscriber> subscribers = new ArrayList<>();
  private boolean closed;

  TransformFeed(RficContext context, RosNode node, SessionClock clock, RosSettings settings, SharedMaster master) {
    this.context = context;
    this.node = node;
    this.clock = clock;
    this.master = master;
    this.namespace = settings.namespace().substring(1).replaceAll("/$", "");
    this.publication = context.offers().stream(
        new StreamPort<>("tf", TransformSet.class, Arity.MANY, "/tf and /tf_static"), Demand.IGNORED);
    if (settings.tf()) {
      master.add(this);
      tick();
    } else {
      closed = true;
    }
  }

  /** Listens for all where nobody does. Called regularly by the thread that follows the graph. */
  synchronized void tick() {
    if (!closed && subscribers.isEmpty() && master.listens(this)) {
      subscribe(false);
      subscribe(true);
    }
  }

  private void subscribe(boolean fixed) {
    subscribers.add(node.subscriber(topic(fixed), RecordCodec.of(TFMessage.class), SubscriberOptions.observing(),
        (message, reception) -> master.heard(message, reception, fixed)));
  }

  private static String topic(boolean fixed) {
    return fixed ? "/tf_static" : "/tf";
  }

  /** The namespace of the robot without slashes at its ends, empty for all. */
  String namespace() {
    return namespace;
  }

  /** Takes what concerns its robot. On the thread of the one that listens. */
  void received(TFMessage all, Reception reception, boolean fixed) {
    List<TransformStamped> own = all.transforms().stream().filter(t -> concerns(t.childFrameId())).toList();
    if (own.isEmpty()) {
      return;
    }
    TFMessage message = new TFMessage(own);
    FrameNames names = clock.names();
    Optional<TransformSet> good = StateAdapters.transforms(message, names, fixed);
    int refused = own.size() - good.map(set -> set.transforms().size()).orElse(0);
    if (refused > 0) {
      publication.lost(refused,
          topic(fixed) + " from " + reception.callerId() + ": " + refused + " of " + own.size()
              + " transforms refused; "
              + StateAdapters.refusal(message, names).orElse(""));
    }
    good.ifPresent(set -> {
      context.frames().add(set, reception.callerId());
      publication.publish(set, clock.stamp(set.transforms().getFirst().stamp().nanos(), names));
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
    return !namespace.startsWith(prefix + "/") && master.isNamespace(prefix);
  }

  @Override
  public synchronized void close() {
    closed = true;
    subscribers.forEach(Subscriber::close);
    master.remove(this);
    publication.close();
  }
}
