package org.robotui.ros;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.CompletionStage;
import org.robotui.message.MessageCodec;
import org.robotui.message.ServiceCodec;
import org.robotui.net.call.Outcome;
import org.robotui.ros.internal.node.NodeRuntime;

/**
 * One node in a ROS graph. Whatever is made with it is registered at the master in the background, as soon as the
 * master can be reached, and again whenever the master forgot it. Any thread may use it.
 */
public interface RosNode extends AutoCloseable {

  /**
   * Opens a node. The master need not be there yet.
   *
   * @param environment the surroundings
   * @param name the node's name, relative to the environment's namespace; a name given on the command line wins
   * @param options what the owner gives it
   * @return the open node
   * @throws IOException if it cannot listen on its own address
   */
  static RosNode open(RosEnvironment environment, GraphName name, NodeOptions options) throws IOException {
    return NodeRuntime.open(environment, name, options);
  }

  /**
   * The node's name.
   *
   * @return a global name
   */
  GraphName name();

  /**
   * The address of the node's own API.
   *
   * @return an {@code http} URI
   */
  String uri();

  /**
   * Resolves names as seen from this node.
   *
   * @return the resolver, with the environment's remappings
   */
  NameResolver names();

  /**
   * Publishes a topic.
   *
   * @param topic the topic's name
   * @param codec the codec of its messages
   * @param options how to send
   * @param <T> the Java value of a message
   * @return the publisher
   * @throws IllegalStateException if this node publishes the topic already, or is closed
   * @throws InvalidNameException if the topic is no name
   */
  <T> Publisher<T> publisher(String topic, MessageCodec<T> codec, PublisherOptions options);

  /**
   * Subscribes to a topic. There may be several subscribers to one topic, also with different codecs: they share one
   * link to each publisher. Those who come later get the last message of a publisher that latches.
   *
   * @param topic the topic's name
   * @param codec the codec of its messages
   * @param options how to receive
   * @param listener hears of the messages
   * @param <T> the Java value of a message
   * @return the subscriber
   * @throws IllegalStateException if the node is closed
   * @throws InvalidNameException if the topic is no name
   */
  <T> Subscriber subscriber(String topic, MessageCodec<T> codec, SubscriberOptions options,
      MessageListener<T> listener);

  /**
   * Offers a service.
   *
   * @param service the service's name
   * @param codec the codec of its calls
   * @param handler answers the calls
   * @param <Q> the Java value of a request
   * @param <R> the Java value of a response
   * @return the server
   * @throws IllegalStateException if this node offers the service already, or is closed
   * @throws InvalidNameException if the service is no name
   */
  <Q, R> ServiceServer serviceServer(String service, ServiceCodec<Q, R> codec, ServiceHandler<Q, R> handler);

  /**
   * Prepares calls to a service. Nothing is sent before the first call.
   *
   * @param service the service's name
   * @param codec the codec of its calls
   * @param persistent whether the connection stays open between calls; it is made again when it broke
   * @param <Q> the Java value of a request
   * @param <R> the Java value of a response
   * @return the client
   * @throws InvalidNameException if the service is no name
   */
  <Q, R> ServiceClient<Q, R> serviceClient(String service, ServiceCodec<Q, R> codec, boolean persistent);

  /**
   * Asks a service's server for the service's type.
   *
   * @param service the service's name
   * @param timeout for the whole call
   * @return what the server says
   */
  Outcome<ServiceIdentity> probeService(String service, Duration timeout);

  /**
   * The parameter server.
   *
   * @return reads and writes parameters
   */
  Parameters parameters();

  /**
   * The graph around this node.
   *
   * @return asks the master
   */
  MasterGraph master();

  /**
   * The node's time.
   *
   * @return wall or simulated time
   */
  NodeClock clock();

  /**
   * Waits until the master knows all that was made with this node so far.
   *
   * @param timeout how long to wait at most
   * @return whether the master knows it all
   */
  boolean awaitRegistered(Duration timeout);

  /**
   * The end of the node.
   *
   * @return completes with the reason once the node is closed, by its owner or because the master asked it to (another
   * node took its name)
   */
  CompletionStage<String> whenClosed();

  /**
   * Tells the master, without waiting for it, that it may forget all of this node; to be followed by {@link #close}.
   * What is connected stays so until then, unless the other side hangs up, as publishers and subscribers may when they
   * hear of it. What is made from now on nobody hears of.
   */
  void leave();

  /**
   * Closes everything in less than a second, also when peers or the master hang, or the caller is interrupted.
   * Unregisters from the master meanwhile.
   */
  @Override
  void close();
}
