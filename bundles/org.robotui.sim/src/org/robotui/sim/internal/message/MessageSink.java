package org.robotui.sim.internal.message;

/**
 * Where the messages of one topic go. For any thread.
 *
 * @param <T> the message
 */
public interface MessageSink<T> {
  /** Whether anybody would see a message, now or later. */
  boolean isWanted();

  void send(T message);
}
