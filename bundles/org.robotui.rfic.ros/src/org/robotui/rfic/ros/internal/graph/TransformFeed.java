package org.robotui.rfic.ros.internal.graph;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Demand;
import org.robotui.api.port.Publication;
import org.robotui.api.port.StreamPort;
import org.robotui.data.TransformSet;
import org.robotui.rfic.ros.internal.RosSettings;
import org.robotui.rfic.ros.internal.convert.FrameNames;
import org.robotui.rfic.ros.internal.convert.StateAdapters;
import org.robotui.ros.Reception;
import org.robotui.ros.RosNode;
import org.robotui.ros.Subscriber;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.msgs.tf2_msgs.TFMessage;

/**
 * Listens to transforms, moving and static. The old type {@code tf/tfMessage} has the same definition, and so the same
 * sum, as the present one.
 */
final class TransformFeed implements AutoCloseable {
  private final RficContext context;
  private final SessionClock clock;
  private final Publication<TransformSet> publication;
  private final List<Subscriber> subscribers = new ArrayList<>();

  TransformFeed(RficContext context, RosNode node, SessionClock clock, RosSettings settings) {
    this.context = context;
    this.clock = clock;
    this.publication = context.offers().stream(
        new StreamPort<>("tf", TransformSet.class, Arity.MANY, "/tf and /tf_static"), Demand.IGNORED);
    if (settings.tf()) {
      subscribe(node, "/tf", false);
      subscribe(node, "/tf_static", true);
    }
  }

  private void subscribe(RosNode node, String topic, boolean fixed) {
    subscribers.add(
        node.subscriber(topic, TFMessage.CODEC, SubscriberOptions.observing(), (m, r) -> received(m, r, fixed)));
  }

  private void received(TFMessage message, Reception reception, boolean fixed) {
    FrameNames names = clock.names();
    Optional<TransformSet> good = StateAdapters.transforms(message, names, fixed);
    good.ifPresent(set -> {
      context.frames().add(set, reception.callerId());
      publication.publish(set, clock.stamp(set.transforms().getFirst().stamp().nanos(), names));
    });
    int refused = message.transforms().size() - good.map(set -> set.transforms().size()).orElse(0);
    if (refused > 0) {
      publication.lost(refused, refused + " transforms of " + reception.callerId() + " are no transforms");
    }
  }

  @Override
  public void close() {
    subscribers.forEach(Subscriber::close);
    publication.close();
  }
}
