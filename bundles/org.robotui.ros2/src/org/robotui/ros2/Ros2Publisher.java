package org.robotui.ros2;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Qos;

/**
 * Sends messages of one topic to all its subscribers. Any thread may use it.
 *
 * @param <T> the Java value of a message
 */
public interface Ros2Publisher<T> extends AutoCloseable {

  /**
   * Encodes the message and sends it; never waits for a subscriber. Nothing is encoded while nobody subscribes, unless
   * late subscribers get it. Does nothing once closed.
   *
   * @param message the message
   * @return false where it was not sent, because all is kept and too much of it is not acknowledged
   */
  boolean publish(T message);

  /**
   * Waits until all that was published is acknowledged by every reliable subscriber. Interrupting does not end it.
   *
   * @param patience at most so long
   * @return false where some of it is not, as for a subscriber that is stopped
   */
  boolean awaitSent(Duration patience);

  /**
   * The topic.
   *
   * @return its whole name
   */
  Ros2Name topic();

  /**
   * What is offered.
   *
   * @return the quality of service
   */
  Qos qos();

  /**
   * How many subscribers get the messages.
   *
   * @return the number of matched readers
   */
  int numSubscribers();

  /**
   * Who gets the messages.
   *
   * @return the nodes whose subscribers match, as far as they are known by name
   */
  Set<Ros2Name> subscribers();

  /**
   * Why subscribers of the topic do not get the messages.
   *
   * @return a sentence for each, for a user to read
   */
  List<String> mismatches();

  /** Takes it back from the network. */
  @Override
  void close();
}
