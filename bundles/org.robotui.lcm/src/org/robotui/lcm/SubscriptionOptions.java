package org.robotui.lcm;

/**
 * How messages reach a listener.
 *
 * @param queue how many messages wait for it at most; 0: it is called on the receiving thread
 * @param queueBytes how many bytes wait for it at most; a single message may be longer
 */
public record SubscriptionOptions(int queue, long queueBytes) {

  private static final long STANDARD_BYTES = 64L << 20;

  /** Checks the bounds. */
  public SubscriptionOptions {
    if (queue < 0 || queueBytes < 1) {
      throw new IllegalArgumentException("a queue of " + queue + " messages and " + queueBytes + " bytes");
    }
  }

  /**
   * The listener is called on the receiving thread, which must not block.
   *
   * @return the options
   */
  public static SubscriptionOptions direct() {
    return new SubscriptionOptions(0, STANDARD_BYTES);
  }

  /**
   * The listener is called on a thread of its own. When it is too slow, the oldest messages that wait are dropped and
   * counted.
   *
   * @param messages how many wait at most, at least 1
   * @return the options
   */
  public static SubscriptionOptions queued(int messages) {
    if (messages < 1) {
      throw new IllegalArgumentException("a queue of " + messages + " messages");
    }
    return new SubscriptionOptions(messages, STANDARD_BYTES);
  }
}
