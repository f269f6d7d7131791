package org.robotui.ros;

/**
 * How a publisher sends.
 *
 * @param latch         whether the last message is kept and sent to each new subscriber
 * @param queueMessages how many messages wait per subscriber before the oldest are dropped
 * @param queueBytes    how many bytes wait per subscriber before the oldest messages are dropped; one always may wait
 */
public record PublisherOptions(boolean latch, int queueMessages, long queueBytes) {

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
        return new PublisherOptions(false, 1000, 64L << 20);
    }

    /**
     * The default with latching.
     *
     * @return the options
     */
    public static PublisherOptions latched() {
        return new PublisherOptions(true, 1000, 64L << 20);
    }

    /**
     * The same options with another bound of the queues.
     *
     * @param messages how many messages may wait per subscriber
     * @return the changed options
     */
    public PublisherOptions withQueue(int messages) {
        return new PublisherOptions(latch, messages, queueBytes);
    }
}
