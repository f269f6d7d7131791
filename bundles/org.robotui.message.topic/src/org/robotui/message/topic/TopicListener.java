package org.robotui.message.topic;

/**
 * Is told of the messages of a topic, on a thread of the framework, which must not be held up.
 *
 * @param <M> the Java value of a message
 */
public interface TopicListener<M> {

  /**
   * A message came.
   *
   * @param message the message
   * @param arrival how it came
   */
  void received(M message, Arrival arrival);

  /**
   * A message came that cannot be read. The subscription goes on.
   *
   * @param reason why
   * @param arrival how it came
   */
  void unreadable(String reason, Arrival arrival);
}
