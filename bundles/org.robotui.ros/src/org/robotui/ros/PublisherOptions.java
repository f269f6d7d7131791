package org.robotui.ros;

/**
 * How a publisher sends.
 *
 * @param latch whether the last message is kept and sent to each new subscriber
 * @param queueMessages how many messages wait per subscriber before the oldest are dropped
 * @param queueBytes how many bytes wait per subscriber before the oldest messages are dropped; one always may wait
 * @param prompt whether as little as possible is entrusted to a network that stalls, because what comes late does harm
 */
public record PublisherOptions(boolean latch, int queueMessages, long queueBytes, boolean prompt) {

  /** Checks the bounds. */
  public PublisherOptions {
    if (queueMessages < 1 || queueBytes < 1) {
      throw new IllegalArgumentException("a queue of " + queueMessages + " messages and " + queueBytes + " bytes");
    }
  }

  /**
   * No latching; queues of 1000 messages and 64 MiB.
   *
   * @return the default
   */
  public static PublisherOptions standard() {
    return new PublisherOptions(false, 1000, 64L << 20, false);
  }

  /**
   * The default with latching.
   *
   * @return the options
   */
  public static PublisherOptions latched() {
    return new PublisherOptions(true, 1000, 64L << 20, false);
  }

  /**
   * The same options with another bound of the queues.
   *
   * @param messages how many messages may wait per subscriber
   * @return the changed options
   */
  public PublisherOptions withQueue(int messages) {
    return new PublisherOptions(latch, messages, queueBytes, prompt);
  }

  /**
   * For commands: only the newest message waits, and a network that stalls holds the few that were on their way and no
   * more, where it would else hold all that a long outage makes, and hand it out at its end.
   *
   * @return the options
   */
  public static PublisherOptions commands() {
    return new PublisherOptions(false, 1, 64L << 20, true);
  }
}
