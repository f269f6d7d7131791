package org.robotui.lcm;

import java.time.Duration;
import java.util.Objects;
import java.util.concurrent.ThreadFactory;
import javax.net.SocketFactory;

/**
 * What a connection is given by its owner.
 *
 * @param threads makes all its threads
 * @param states hears of its state
 * @param maxMessageBytes the longest message that is accepted
 * @param partialBytes how much memory messages may hold of which fragments are missing, all together
 * @param partialTime how long such a message waits for its next fragment
 * @param receiveBuffer the receive buffer that the kernel is asked for, unless the URL says {@code recv_buf_size}
 * @param connectTime how long a server may take to answer
 * @param minBackoff the pause after the first failed attempt; doubles with each further one
 * @param maxBackoff the longest pause between attempts
 * @param sockets makes the sockets to servers, not yet connected
 */
public record LcmOptions(ThreadFactory threads, LcmStateListener states, int maxMessageBytes, long partialBytes,
    Duration partialTime,
    int receiveBuffer, Duration connectTime, Duration minBackoff, Duration maxBackoff, SocketFactory sockets) {

  /** Checks the bounds. */
  public LcmOptions {
    Objects.requireNonNull(threads, "threads");
    Objects.requireNonNull(states, "states");
    Objects.requireNonNull(sockets, "sockets");
    if (maxMessageBytes < 1 || maxMessageBytes > Integer.MAX_VALUE - 8 || partialBytes < 1 || receiveBuffer < 1) {
      throw new IllegalArgumentException("messages of " + maxMessageBytes + ", partial ones of " + partialBytes
          + ", a receive buffer of " + receiveBuffer + " bytes");
    }
    if (minBackoff.isNegative() || minBackoff.isZero() || maxBackoff.compareTo(minBackoff) < 0) {
      throw new IllegalArgumentException("back-off from " + minBackoff + " to " + maxBackoff);
    }
  }

  /**
   * Messages up to 64 MiB, as much for partial ones, which wait for 1 s; a receive buffer of 16 MiB, if the kernel
   * gives it; 5 s for a server, back-off from 0.1 to 5 s.
   *
   * @param threads makes all threads of the connection
   * @return the default
   */
  public static LcmOptions standard(ThreadFactory threads) {
    return new LcmOptions(threads, LcmStateListener.none(), 64 << 20, 64L << 20, Duration.ofSeconds(1), 16 << 20,
        Duration.ofSeconds(5),
        Duration.ofMillis(100), Duration.ofSeconds(5), SocketFactory.getDefault());
  }

  /**
   * The same options with a listener.
   *
   * @param listener hears of the state
   * @return the changed options
   */
  public LcmOptions withStates(LcmStateListener listener) {
    return new LcmOptions(threads, listener, maxMessageBytes, partialBytes, partialTime, receiveBuffer, connectTime,
        minBackoff, maxBackoff,
        sockets);
  }

  /**
   * The same options with other bounds.
   *
   * @param messageBytes the longest message that is accepted
   * @param partial how much memory messages may hold of which fragments are missing
   * @param wait how long such a message waits for its next fragment
   * @return the changed options
   */
  public LcmOptions withBounds(int messageBytes, long partial, Duration wait) {
    return new LcmOptions(threads, states, messageBytes, partial, wait, receiveBuffer, connectTime, minBackoff,
        maxBackoff,
        sockets);
  }

  /**
   * The same options with other times.
   *
   * @param connect how long a server may take to answer
   * @param longest the longest pause between attempts
   * @return the changed options
   */
  public LcmOptions withTimes(Duration connect, Duration longest) {
    return new LcmOptions(threads, states, maxMessageBytes, partialBytes, partialTime, receiveBuffer, connect,
        minBackoff, longest,
        sockets);
  }

  /**
   * The same options with other sockets to servers, for example such that another process keeps.
   *
   * @param made makes them, not yet connected; they close and time out as usual ones do
   * @return the changed options
   */
  public LcmOptions withSockets(SocketFactory made) {
    return new LcmOptions(threads, states, maxMessageBytes, partialBytes, partialTime, receiveBuffer, connectTime,
        minBackoff, maxBackoff,
        made);
  }
}
