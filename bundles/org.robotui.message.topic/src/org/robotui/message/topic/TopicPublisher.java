package org.robotui.message.topic;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;

/**
 * Says messages on a topic. Any thread may use it.
 *
 * @param <M> the Java value of a message
 */
public interface TopicPublisher<M> extends AutoCloseable {

  /**
   * How many subscribers hear it.
   *
   * @return the number of those that are connected now
   */
  int subscribers();

  /**
   * Why subscribers of the topic do not hear it.
   *
   * @return a sentence, or none where nothing is known to be wrong
   */
  default Optional<String> obstacle() {
    return Optional.empty();
  }

  /**
   * Says a message; never waits for a subscriber.
   *
   * @param message the message
   */
  void publish(M message);

  /**
   * Says a message of the topic's type that came from elsewhere, as it is.
   *
   * @param encoding the name of its encoding
   * @param bytes the whole message
   * @return false where this framework has another encoding: nothing was said then
   */
  default boolean publishRaw(String encoding, ByteBuffer bytes) {
    return false;
  }

  /**
   * Says a message next, and drops those that still wait: a stop comes right behind what is on its way already.
   *
   * @param message the message
   */
  void publishUrgently(M message);

  /**
   * Waits until all that was published is handed to the network: closing drops what waits.
   *
   * @param patience at most so long
   */
  void awaitSent(Duration patience);

  /** Offers the topic no longer. */
  @Override
  void close();
}
