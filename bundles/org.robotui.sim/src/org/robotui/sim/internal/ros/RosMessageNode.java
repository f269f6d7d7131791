package org.robotui.sim.internal.ros;

import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerInit;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.ServiceException;
import org.robotui.ros.SubscriberOptions;
import org.robotui.sim.internal.message.MessageNode;
import org.robotui.sim.internal.message.MessageSink;
import org.robotui.sim.internal.message.TopicKind;

/** A node of ROS 1. */
final class RosMessageNode implements MessageNode {
  private static final int QUEUE = 50;
  private static final int QUEUE_OF_LARGE = 3;

  private final RosNode node;

  RosMessageNode(RosNode node) {
    this.node = node;
  }

  /** A topic's publisher; messages are wanted also where nobody subscribes yet if the last one is kept. */
  private record Sink<T>(Publisher<T> publisher, boolean kept) implements MessageSink<T> {
    @Override
    public boolean isWanted() {
      return kept || publisher.numSubscribers() > 0;
    }

    @Override
    public void send(T message) {
      publisher.publish(message);
    }
  }

  @Override
  public String name() {
    return node.name().text().substring(1);
  }

  /** The whole name that another one has as seen from here. */
  String resolved(String name) {
    return node.names().resolve(name).text();
  }

  @Override
  public <T extends Record> MessageSink<T> topic(String name, Class<T> type, TopicKind kind) {
    boolean kept = kind == TopicKind.LATCHED || kind == TopicKind.SELDOM;
    PublisherOptions options = kept ? PublisherOptions.latched() : PublisherOptions.standard();
    int queue = kind == TopicKind.LARGE ? QUEUE_OF_LARGE : QUEUE;
    return new Sink<>(node.publisher(name, RecordCodec.of(type), options.withQueue(queue)), kept);
  }

  @Override
  public <T extends Record> void listen(String name, Class<T> type, Consumer<T> taken) {
    node.subscriber(name, RecordCodec.of(type), SubscriberOptions.standard(), (message, from) -> taken.accept(message));
  }

  @Override
  public <Q extends Record, R extends Record> void service(String name, String type, Class<Q> request,
      Class<R> response, Function<Q, R> answer) {
    node.serviceServer(name, RecordCodec.service(type, request, response), (asked, caller) -> {
      try {
        return answer.apply(asked);
      } catch (IllegalStateException e) {
        throw new ServiceException(e.getMessage());
      }
    });
  }

  @Override
  public Runnable markers(String server, Supplier<InteractiveMarkerInit> now) {
    MessageSink<InteractiveMarkerInit> all =
        topic(server + "/update_full", InteractiveMarkerInit.class, TopicKind.LATCHED);
    all.send(now.get());
    return () -> all.send(now.get());
  }
}
