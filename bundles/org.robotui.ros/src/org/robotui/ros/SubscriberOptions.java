package org.robotui.ros;

/**
 * How a subscriber receives.
 *
 * @param tcpNoDelay whether publishers are asked to send small messages at once
 */
public record SubscriberOptions(boolean tcpNoDelay) {

    /**
     * Small messages at once.
     *
     * @return the default
     */
    public static SubscriberOptions standard() {
        return new SubscriberOptions(true);
    }
}
