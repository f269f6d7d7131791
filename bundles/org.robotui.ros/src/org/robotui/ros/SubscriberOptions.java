package org.robotui.ros;

/**
 * How a subscriber receives.
 *
 * @param tcpNoDelay whether publishers are asked to send small messages at once
 * @param announcesType whether the master is told which type is wanted; it remembers that of a topic that nobody
 * publishes even after the subscriber has gone
 */
public record SubscriberOptions(boolean tcpNoDelay, boolean announcesType) {

  /**
   * Small messages at once; the type is announced, so that publishers can be found for it.
   *
   * @return the default
   */
  public static SubscriberOptions standard() {
    return new SubscriberOptions(true, true);
  }

  /**
   * The default for those who leave no trace: the master does not learn a type from them.
   *
   * @return the options
   */
  public static SubscriberOptions observing() {
    return new SubscriberOptions(true, false);
  }
}
