package org.robotui.ros;

/**
 * Hears of messages.
 *
 * @param <T> the Java value of a message
 */
@FunctionalInterface
public interface MessageListener<T> {

  /**
   * A message came in. Called on the I/O thread of the publisher's link, or once on another one for what the publisher
   * has latched; one call at a time per subscriber, in the order of each publisher. Must not block, as other
   * subscribers of the node wait for it. What it throws is logged and counted, and the link goes on.
   *
   * @param value the decoded message
   * @param reception where it came from and its bytes
   */
  void onMessage(T value, Reception reception);
}
