package org.robotui.ros2;

import java.util.concurrent.CompletableFuture;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.ros2.name.Ros2NameResolver;
import org.robotui.rtps.Qos;

/** One node in a graph of ROS 2. Any thread may use it. */
public interface Ros2Node extends AutoCloseable {

  /**
   * The node's name.
   *
   * @return the whole name
   */
  Ros2Name name();

  /**
   * Resolves names as seen from this node.
   *
   * @return the resolver, with the context's remappings
   */
  Ros2NameResolver names();

  /**
   * The context that it belongs to.
   *
   * @return the context
   */
  Ros2Context context();

  /**
   * Publishes a topic. There may be several publishers of one topic.
   *
   * @param topic the topic's name
   * @param codec the codec of its messages
   * @param qos what is offered, see {@link QosProfiles}
   * @param <T> the Java value of a message
   * @return the publisher
   * @throws IllegalStateException if the node is closed
   * @throws IllegalArgumentException if the topic is no name
   */
  <T> Ros2Publisher<T> publisher(String topic, Ros2Codec<T> codec, Qos qos);

  /**
   * Subscribes to a topic. There may be several subscribers to one topic.
   *
   * @param topic the topic's name
   * @param codec the codec of its messages
   * @param options how to receive
   * @param listener hears of the messages
   * @param <T> the Java value of a message
   * @return the subscriber
   * @throws IllegalStateException if the node is closed
   * @throws IllegalArgumentException if the topic is no name
   */
  <T> Ros2Subscriber subscriber(String topic, Ros2Codec<T> codec, Ros2SubscriberOptions options,
      Ros2Listener<T> listener);

  /**
   * Offers a service.
   *
   * @param service the service's name
   * @param codec the codec of its calls
   * @param handler answers the calls
   * @param <Q> the Java value of a request
   * @param <R> the Java value of a response
   * @return the server
   * @throws IllegalStateException if the node is closed
   * @throws IllegalArgumentException if the service is no name
   */
  default <Q, R> Ros2ServiceServer serviceServer(String service, Ros2ServiceCodec<Q, R> codec,
      Ros2ServiceHandler<Q, R> handler) {
    return serviceServer(service, codec, QosProfiles.SERVICES, handler);
  }

  /**
   * Offers a service.
   *
   * @param service the service's name
   * @param codec the codec of its calls
   * @param qos of requests and replies
   * @param handler answers the calls
   * @param <Q> the Java value of a request
   * @param <R> the Java value of a response
   * @return the server
   * @throws IllegalStateException if the node is closed
   * @throws IllegalArgumentException if the service is no name
   */
  default <Q, R> Ros2ServiceServer serviceServer(String service, Ros2ServiceCodec<Q, R> codec, Qos qos,
      Ros2ServiceHandler<Q, R> handler) {
    return deferringServer(service, codec, qos,
        (request, caller) -> CompletableFuture.completedStage(handler.handle(request, caller)));
  }

  /**
   * Offers a service of which calls are answered later.
   *
   * @param service the service's name
   * @param codec the codec of its calls
   * @param qos of requests and replies
   * @param handler answers the calls
   * @param <Q> the Java value of a request
   * @param <R> the Java value of a response
   * @return the server
   * @throws IllegalStateException if the node is closed
   * @throws IllegalArgumentException if the service is no name
   */
  <Q, R> Ros2ServiceServer deferringServer(String service, Ros2ServiceCodec<Q, R> codec, Qos qos,
      Ros2DeferringHandler<Q, R> handler);

  /**
   * Prepares calls to a service. The server need not be there yet.
   *
   * @param service the service's name
   * @param codec the codec of its calls
   * @param <Q> the Java value of a request
   * @param <R> the Java value of a response
   * @return the client
   * @throws IllegalStateException if the node is closed
   * @throws IllegalArgumentException if the service is no name
   */
  default <Q, R> Ros2ServiceClient<Q, R> serviceClient(String service, Ros2ServiceCodec<Q, R> codec) {
    return serviceClient(service, codec, QosProfiles.SERVICES);
  }

  /**
   * Prepares calls to a service. The server need not be there yet.
   *
   * @param service the service's name
   * @param codec the codec of its calls
   * @param qos of requests and replies
   * @param <Q> the Java value of a request
   * @param <R> the Java value of a response
   * @return the client
   * @throws IllegalStateException if the node is closed
   * @throws IllegalArgumentException if the service is no name
   */
  <Q, R> Ros2ServiceClient<Q, R> serviceClient(String service, Ros2ServiceCodec<Q, R> codec, Qos qos);

  /**
   * The node's time.
   *
   * @return wall time until {@link Ros2Clock#simulated} says otherwise
   */
  Ros2Clock clock();

  /** Closes all that was made with it. */
  @Override
  void close();
}
