package org.robotui.player.client;

import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import javax.net.SocketFactory;

/**
 * What a client is given by its owner.
 *
 * @param threads makes the client's two threads
 * @param links hears of the state of the link
 * @param key what a server with a key wants to hear; at most 32 bytes
 * @param pull how often to fetch data; if empty the server sends them as they come. A client that fetches never holds
 * data up at the server when it is slow
 * @param newestOnly whether the server shall keep only the newest of like data while they wait
 * @param handshake for connecting and all that comes before the first subscription
 * @param messageTime for the rest of a message that has begun
 * @param answerTime for the answer to a request
 * @param maxRequests how many requests may wait for their answers
 * @param minBackoff the pause after the first failed attempt to reach the server; doubles with each further one
 * @param maxBackoff the longest pause between attempts
 * @param sockets makes the sockets, not yet connected
 */
public record ClientOptions(ThreadFactory threads, LinkListener links, Optional<byte[]> key, Optional<Duration> pull,
    boolean newestOnly,
    Duration handshake, Duration messageTime, Duration answerTime, int maxRequests, Duration minBackoff,
    Duration maxBackoff,
    SocketFactory sockets) {

  private static final int KEY_BYTES = 32;

  /** Checks the bounds. */
  public ClientOptions {
    Objects.requireNonNull(threads, "threads");
    Objects.requireNonNull(links, "links");
    Objects.requireNonNull(sockets, "sockets");
    if (key.filter(bytes -> bytes.length > KEY_BYTES).isPresent() || maxRequests < 1) {
      throw new IllegalArgumentException("a key has at most 32 bytes, and at least one request must be possible");
    }
    if (pull.filter(period -> period.isNegative() || period.isZero()).isPresent()) {
      throw new IllegalArgumentException("data cannot be fetched every " + pull.get());
    }
    if (minBackoff.isNegative() || minBackoff.isZero() || maxBackoff.compareTo(minBackoff) < 0) {
      throw new IllegalArgumentException("back-off from " + minBackoff + " to " + maxBackoff);
    }
  }

  /**
   * No key, data as they come, 5 s for the handshake, 5 s for a message, 5 s for an answer, 256 requests, back-off from
   * 0.1 to 5 s.
   *
   * @param threads makes the client's threads
   * @return the default
   */
  public static ClientOptions standard(ThreadFactory threads) {
    return new ClientOptions(threads, LinkListener.none(), Optional.empty(), Optional.empty(), false,
        Duration.ofSeconds(5),
        Duration.ofSeconds(5), Duration.ofSeconds(5), 256, Duration.ofMillis(100), Duration.ofSeconds(5),
        SocketFactory.getDefault());
  }

  /**
   * The same options with a listener.
   *
   * @param listener hears of the state of the link
   * @return the changed options
   */
  public ClientOptions withLinks(LinkListener listener) {
    return new ClientOptions(threads, listener, key, pull, newestOnly, handshake, messageTime, answerTime, maxRequests,
        minBackoff,
        maxBackoff, sockets);
  }

  /**
   * The same options with a key.
   *
   * @param bytes at most 32
   * @return the changed options
   */
  public ClientOptions withKey(byte[] bytes) {
    return new ClientOptions(threads, links, Optional.of(bytes.clone()), pull, newestOnly, handshake, messageTime,
        answerTime, maxRequests,
        minBackoff, maxBackoff, sockets);
  }

  /**
   * The same options, fetching the newest data.
   *
   * @param period how often
   * @return the changed options
   */
  public ClientOptions withPull(Duration period) {
    return new ClientOptions(threads, links, key, Optional.of(period), true, handshake, messageTime, answerTime,
        maxRequests, minBackoff,
        maxBackoff, sockets);
  }

  /**
   * The same options with other times.
   *
   * @param beginning for the handshake
   * @param message for the rest of a message
   * @param answer for an answer
   * @param longestWait the longest pause between attempts
   * @return the changed options
   */
  public ClientOptions withTimes(Duration beginning, Duration message, Duration answer, Duration longestWait) {
    return new ClientOptions(threads, links, key, pull, newestOnly, beginning, message, answer, maxRequests, minBackoff,
        longestWait,
        sockets);
  }

  /**
   * The same options with other sockets, for example such that another process keeps.
   *
   * @param made makes them, not yet connected; they close and time out as usual ones do
   * @return the changed options
   */
  public ClientOptions withSockets(SocketFactory made) {
    return new ClientOptions(threads, links, key, pull, newestOnly, handshake, messageTime, answerTime, maxRequests,
        minBackoff, maxBackoff,
        made);
  }
}
