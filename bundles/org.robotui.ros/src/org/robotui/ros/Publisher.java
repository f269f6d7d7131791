package org.robotui.ros;

import java.time.Duration;
import java.util.Optional;
import java.util.Set;

/**
 * Sends messages of one topic to all its subscribers. Any thread may use it.
 *
 * @param <T> the Java value of a message
 */
public interface Publisher<T> extends AutoCloseable {

  /**
   * Encodes the message and queues it for each subscriber; never waits for one. Nothing is encoded while nobody
   * subscribes, unless the publisher latches. Does nothing once closed.
   *
   * @param message the message
   */
  void publish(T message);

  /**
   * Publishes for one of several senders that this publisher stands for, as one that plays a recording does.
   *
   * @param message the message
   * @param keptFor the sender whose last message it is: where the publisher latches, a new subscriber is sent the last
   * one of each sender, in the order in which they were published, and what was published without a sender is that of
   * one more; none where the message is not kept
   */
  void publish(T message, Optional<String> keptFor);

  /**
   * Sends a message next, and drops those that still wait: a stop comes right behind what is on its way already.
   *
   * @param message the message
   */
  void publishUrgently(T message);

  /**
   * Waits until all that was published is handed to the network, for every subscriber: closing drops what waits.
   * Interrupting does not end it.
   *
   * @param patience at most so long
   * @return false where some of it still waits, as for a subscriber that does not read
   */
  boolean awaitSent(Duration patience);

  /**
   * The topic.
   *
   * @return its global name
   */
  GraphName topic();

  /**
   * How many subscribers are connected.
   *
   * @return the number of links
   */
  int numSubscribers();

  /**
   * Who is connected.
   *
   * @return the node names the subscribers announced
   */
  Set<String> subscribers();

  /**
   * How many messages were dropped because a subscriber was too slow, over all subscribers so far.
   *
   * @return the number of messages
   */
  long dropped();

  /** Unregisters from the master, in the background, and closes all links. */
  @Override
  void close();
}
