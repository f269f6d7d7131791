package org.robotui.roboframe.link;

import java.time.Duration;
import java.util.concurrent.ThreadFactory;

/**
 * How links are made.
 *
 * @param application what we are called
 * @param threads makes their threads
 * @param patience how long connecting may take, and the other side until it has said who it is
 * @param prompt whether as little as possible is entrusted to the network: what is commanded comes now or never, and
 * large values take longer
 */
public record BrokerOptions(String application, ThreadFactory threads, Duration patience, boolean prompt) {

  private static final Duration PATIENCE = Duration.ofSeconds(3);

  /**
   * The usual ones.
   *
   * @param application what we are called
   * @param threads makes the threads
   * @return with a patience of three seconds
   */
  public static BrokerOptions of(String application, ThreadFactory threads) {
    return new BrokerOptions(application, threads, PATIENCE, false);
  }
}
