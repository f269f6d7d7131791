package org.robotui.ros;

/**
 * Hears of messages.
 *
 * @param <T> the Java value of a message
 */
@FunctionalInterface
public interface MessageListener<T> {

  /**
   * A message came in. Called on the I/O thread of the publisher's link, one call at a time per subscriber, in the
   * order of each publisher; must not block. What it throws is logged and counted, and the link goes on.
   *
   * @param value the decoded message
   * @param reception where it came from and its bytes
   */
  void onMessage(T value, Reception reception);
}
