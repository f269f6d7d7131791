package org.robotui.lcm;

import java.io.IOException;
import java.nio.ByteBuffer;
import org.robotui.lcm.internal.client.LcmClient;

/**
 * One connection to LCM's messages. It is opened in the background, and again when it broke. Any thread may use it.
 *
 * <p>Providers: {@code udpm} (UDP multicast; options {@code ttl}, {@code recv_buf_size} in bytes and
 * {@code interface}), {@code tcpq} (a server), {@code file} (an event log; options {@code mode=r|w|a}, {@code speed},
 * where 0 is as fast as possible, and {@code start_timestamp} in microseconds) and {@code memq} (within this object).
 */
public interface Lcm extends AutoCloseable {

  /**
   * Opens a connection.
   *
   * @param url where to
   * @param options what the owner gives it
   * @return the connection, which may not be there yet: its state says when it is
   * @throws IllegalArgumentException if the URL is wrong; the message says what to write
   */
  static Lcm open(LcmUrl url, LcmOptions options) {
    return LcmClient.open(url, options);
  }

  /**
   * Checks a URL without connecting.
   *
   * @param url where to
   * @throws IllegalArgumentException if the URL is wrong; the message says what to write
   */
  static void check(LcmUrl url) {
    LcmClient.check(url);
  }

  /**
   * Where it leads.
   *
   * @return the URL
   */
  LcmUrl url();

  /**
   * Sends a message.
   *
   * @param channel the channel: 1 to 63 bytes of UTF-8 without a zero
   * @param data the bytes, from position to limit
   * @throws IOException if it cannot be sent; the message names the channel and the cause
   * @throws IllegalArgumentException if the channel is no name
   */
  void publish(String channel, ByteBuffer data) throws IOException;

  /**
   * Subscribes to channels.
   *
   * @param channels a regular expression that the whole name of a channel must match, such as {@code POSE|LASER_.*}
   * @param options how messages reach the listener
   * @param listener hears of the messages
   * @return the subscription
   * @throws IllegalArgumentException if it is no regular expression
   * @throws IllegalStateException if the connection is closed
   */
  Subscription subscribe(String channels, SubscriptionOptions options, LcmListener listener);

  /**
   * How it stands.
   *
   * @return the state
   */
  LcmState state();

  /**
   * What was counted.
   *
   * @return the figures so far
   */
  LcmStatistics statistics();

  /** Closes everything in less than a second. */
  @Override
  void close();
}
