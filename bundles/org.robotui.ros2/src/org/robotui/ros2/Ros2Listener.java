package org.robotui.ros2;

/**
 * Hears of messages.
 *
 * @param <T> the Java value of a message
 */
@FunctionalInterface
public interface Ros2Listener<T> {

  /**
   * A message came in. Called on the receiving thread of the context, one call at a time, in the order of each
   * publisher; must not block, as all of the context waits for it. What it throws is logged and counted.
   *
   * @param value the decoded message
   * @param reception where it came from and its bytes
   */
  void onMessage(T value, Ros2Reception reception);
}
