package org.robotui.gazebo;

import java.util.function.IntSupplier;
import java.util.function.Predicate;

/** A topic that we publish. Safe for all threads. */
public final class GazeboPublisher implements AutoCloseable {
  private final Predicate<byte[]> sending;
  private final IntSupplier listening;
  private final Runnable end;
  private volatile boolean closed;

  GazeboPublisher(Predicate<byte[]> sending, IntSupplier listening, Runnable end) {
    this.sending = sending;
    this.listening = listening;
    this.end = end;
  }

  /**
   * How many nodes of other processes receive it.
   *
   * @return those that have said so
   */
  public int subscribers() {
    return closed ? 0 : listening.getAsInt();
  }

  /**
   * Publishes a message, without waiting for anybody: for a subscriber that does not read, it is dropped.
   *
   * @param payload the message
   * @return whether it is on its way; if not, it never will be
   */
  public boolean publish(byte[] payload) {
    return !closed && sending.test(payload);
  }

  /** Publishes the topic no longer. What was published is still sent. */
  @Override
  public void close() {
    if (!closed) {
      closed = true;
      end.run();
    }
  }
}
