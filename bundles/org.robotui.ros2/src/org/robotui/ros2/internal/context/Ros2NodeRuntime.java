package org.robotui.ros2.internal.context;

import java.time.InstantSource;
import java.util.function.Supplier;
import org.robotui.message.ros.rosgraph_msgs.Clock;
import org.robotui.net.thread.Workers;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Clock;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2DeferringHandler;
import org.robotui.ros2.Ros2Listener;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Publisher;
import org.robotui.ros2.Ros2ServiceClient;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.Ros2ServiceServer;
import org.robotui.ros2.Ros2Subscriber;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.ros2.internal.link.ClientLink;
import org.robotui.ros2.internal.link.ClockLink;
import org.robotui.ros2.internal.link.Ends;
import org.robotui.ros2.internal.link.PublisherLink;
import org.robotui.ros2.internal.link.ServerLink;
import org.robotui.ros2.internal.link.SubscriberLink;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.ros2.name.Ros2NameResolver;
import org.robotui.rtps.Qos;

/** A node and all that was made with it. */
final class Ros2NodeRuntime implements Ros2Node {

  private final ContextRuntime context;
  private final Ros2NameResolver names;
  private final Ends ends;
  private final Workers workers;
  private final ClockLink clock;
  private boolean closed;

  Ros2NodeRuntime(ContextRuntime context, Ros2NameResolver names, Ends ends, Workers workers) {
    this.context = context;
    this.names = names;
    this.ends = ends;
    this.workers = workers;
    clock = new ClockLink(InstantSource.system(), this::time);
  }

  private Ros2Subscriber time(Ros2Listener<Long> listener) {
    return subscriber("/clock", Ros2Codec.of(Clock.class), new Ros2SubscriberOptions(QosProfiles.CLOCK, false),
        (message, from) -> listener.onMessage(message.clock(), from));
  }

  @Override
  public Ros2Name name() {
    return names.node();
  }

  @Override
  public Ros2NameResolver names() {
    return names;
  }

  @Override
  public Ros2Context context() {
    return context;
  }

  private synchronized <L extends AutoCloseable> L keep(Supplier<L> maker) {
    if (closed) {
      throw new IllegalStateException("node " + name() + " is closed");
    }
    return ends.opened(maker.get());
  }

  @Override
  public <T> Ros2Publisher<T> publisher(String topic, Ros2Codec<T> codec, Qos qos) {
    Ros2Name name = names.topic(topic);
    return keep(() -> new PublisherLink<>(ends, name, codec, qos));
  }

  @Override
  public <T> Ros2Subscriber subscriber(String topic, Ros2Codec<T> codec, Ros2SubscriberOptions options,
      Ros2Listener<T> listener) {
    Ros2Name name = names.topic(topic);
    return keep(() -> new SubscriberLink<>(ends, name, codec, options, listener));
  }

  @Override
  public <Q, R> Ros2ServiceServer deferringServer(String service, Ros2ServiceCodec<Q, R> codec, Qos qos,
      Ros2DeferringHandler<Q, R> handler) {
    Ros2Name name = names.service(service);
    return keep(() -> new ServerLink<>(ends, workers, name, codec, qos, handler));
  }

  @Override
  public <Q, R> Ros2ServiceClient<Q, R> serviceClient(String service, Ros2ServiceCodec<Q, R> codec, Qos qos) {
    Ros2Name name = names.service(service);
    return keep(() -> new ClientLink<>(ends, name, codec, qos));
  }

  @Override
  public Ros2Clock clock() {
    return clock;
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
    }
    ends.closeAll();
    context.left(this);
  }
}
