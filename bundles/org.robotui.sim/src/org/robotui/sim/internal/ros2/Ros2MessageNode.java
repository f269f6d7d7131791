package org.robotui.sim.internal.ros2;

import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.robotui.message.ros.visualization_msgs.GetInteractiveMarkersRequest;
import org.robotui.message.ros.visualization_msgs.GetInteractiveMarkersResponse;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerInit;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.Ros2Codec;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Publisher;
import org.robotui.ros2.Ros2ServiceCodec;
import org.robotui.ros2.Ros2SubscriberOptions;
import org.robotui.rtps.Durability;
import org.robotui.rtps.Qos;
import org.robotui.sim.internal.message.MessageNode;
import org.robotui.sim.internal.message.MessageSink;
import org.robotui.sim.internal.message.TopicKind;

/** A node of ROS 2, with the quality of service that its drivers, navigation and publishers of states use. */
final class Ros2MessageNode implements MessageNode {
  private final Ros2Node node;

  Ros2MessageNode(Ros2Node node) {
    this.node = node;
  }

  /** A topic's publisher. */
  private record Sink<T>(Ros2Publisher<T> publisher) implements MessageSink<T> {
    @Override
    public boolean isWanted() {
      return publisher.qos().durability() != Durability.VOLATILE || publisher.numSubscribers() > 0;
    }

    @Override
    public void send(T message) {
      publisher.publish(message);
    }
  }

  private static Qos qos(TopicKind kind) {
    return switch (kind) {
      case SENSOR, LARGE -> QosProfiles.SENSOR_DATA;
      case STATE, SELDOM -> QosProfiles.DEFAULT;
      case LATCHED -> QosProfiles.LATCHED;
      case TRANSFORMS -> QosProfiles.TF;
      case CLOCK -> QosProfiles.CLOCK;
    };
  }

  @Override
  public String name() {
    return node.name().text().substring(1);
  }

  @Override
  public <T extends Record> MessageSink<T> topic(String name, Class<T> type, TopicKind kind) {
    return new Sink<>(node.publisher(name, Ros2Codec.of(type), qos(kind)));
  }

  @Override
  public <T extends Record> void listen(String name, Class<T> type, Consumer<T> taken) {
    node.subscriber(name, Ros2Codec.of(type), Ros2SubscriberOptions.of(QosProfiles.DEFAULT),
        (message, from) -> taken.accept(message));
  }

  @Override
  public <Q extends Record, R extends Record> void service(String name, String type, Class<Q> request,
      Class<R> response, Function<Q, R> answer) {
    node.serviceServer(name, Ros2ServiceCodec.of(type.replace("/", "/srv/"), request, response),
        (asked, caller) -> answer.apply(asked));
  }

  /** Clients of ROS 2 ask for them. */
  @Override
  public Runnable markers(String server, Supplier<InteractiveMarkerInit> now) {
    service(server + "/get_interactive_markers", "visualization_msgs/GetInteractiveMarkers",
        GetInteractiveMarkersRequest.class, GetInteractiveMarkersResponse.class, request -> {
          InteractiveMarkerInit all = now.get();
          return new GetInteractiveMarkersResponse(all.seqNum(), all.markers());
        });
    return () -> {};
  }
}
