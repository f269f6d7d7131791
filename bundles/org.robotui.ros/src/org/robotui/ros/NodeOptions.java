package org.robotui.ros;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import javax.net.SocketFactory;

/**
 * What a node is given by its owner.
 *
 * @param threads makes all threads of the node
 * @param links hears of the state of all links
 * @param maxMessageBytes the longest message that is accepted; at most {@code Integer.MAX_VALUE - 8}
 * @param maxHeaderBytes the longest connection header that is accepted
 * @param handshakeTimeout for connecting and for each header, not for messages
 * @param masterCheck how often the node checks that the master still knows it
 * @param minBackoff the pause after the first failed attempt to reach a peer; doubles with each further one
 * @param maxBackoff the longest pause between attempts
 * @param records a folder where the node keeps a note of itself while it is registered, see {@link StaleRegistrations};
 * none if empty
 * @param sockets makes the sockets to publishers and services, not yet connected
 * @param farewells takes what shall be said to the master when this process cannot say it itself
 */
public record NodeOptions(ThreadFactory threads, LinkListener links, long maxMessageBytes, int maxHeaderBytes,
    Duration handshakeTimeout, Duration masterCheck, Duration minBackoff, Duration maxBackoff, Optional<Path> records,
    SocketFactory sockets, UnregisterHandler farewells) {

  /** Checks the bounds. */
  public NodeOptions {
    Objects.requireNonNull(threads, "threads");
    Objects.requireNonNull(links, "links");
    Objects.requireNonNull(records, "records");
    Objects.requireNonNull(sockets, "sockets");
    Objects.requireNonNull(farewells, "farewells");
    if (maxMessageBytes < 1 || maxMessageBytes > Integer.MAX_VALUE - 8 || maxHeaderBytes < 64) {
      throw new IllegalArgumentException(
          "messages of " + maxMessageBytes + " and headers of " + maxHeaderBytes + " bytes");
    }
    if (minBackoff.isNegative() || minBackoff.isZero() || maxBackoff.compareTo(minBackoff) < 0) {
      throw new IllegalArgumentException("back-off from " + minBackoff + " to " + maxBackoff);
    }
  }

  /**
   * Messages up to 1 GiB, headers up to 1 MiB, 5 s for a handshake, a master check every 2 s, back-off from 0.1 to 5 s.
   *
   * @param threads makes all threads of the node
   * @return the default
   */
  public static NodeOptions standard(ThreadFactory threads) {
    return new NodeOptions(threads, LinkListener.none(), 1L << 30, 1 << 20, Duration.ofSeconds(5),
        Duration.ofSeconds(2),
        Duration.ofMillis(100), Duration.ofSeconds(5), Optional.empty(), SocketFactory.getDefault(),
        UnregisterHandler.none());
  }

  /**
   * The same options with a listener.
   *
   * @param listener hears of the state of all links
   * @return the changed options
   */
  public NodeOptions withLinks(LinkListener listener) {
    return new NodeOptions(threads, listener, maxMessageBytes, maxHeaderBytes, handshakeTimeout, masterCheck,
        minBackoff,
        maxBackoff, records, sockets, farewells);
  }

  /**
   * The same options with another bound of messages.
   *
   * @param bytes the longest message that is accepted
   * @return the changed options
   */
  public NodeOptions withMaxMessageBytes(long bytes) {
    return new NodeOptions(threads, links, bytes, maxHeaderBytes, handshakeTimeout, masterCheck, minBackoff, maxBackoff,
        records,
        sockets, farewells);
  }

  /**
   * The same options with other times.
   *
   * @param handshake for connecting and for each header
   * @param check how often the node checks that the master still knows it
   * @param longestWait the longest pause between attempts to reach a peer
   * @return the changed options
   */
  public NodeOptions withTimes(Duration handshake, Duration check, Duration longestWait) {
    return new NodeOptions(threads, links, maxMessageBytes, maxHeaderBytes, handshake, check, minBackoff, longestWait,
        records,
        sockets, farewells);
  }

  /**
   * The same options with a folder for notes.
   *
   * @param folder where the node keeps a note of itself, so that {@link StaleRegistrations} can clear up after a kill;
   * made if it is not there
   * @return the changed options
   */
  public NodeOptions withRecords(Path folder) {
    return new NodeOptions(threads, links, maxMessageBytes, maxHeaderBytes, handshakeTimeout, masterCheck, minBackoff,
        maxBackoff,
        Optional.of(folder), sockets, farewells);
  }

  /**
   * The same options for a node of which another process takes care, too.
   *
   * @param made makes sockets, not yet connected; they close and time out as usual ones do
   * @param taker what shall be said to the master when this process cannot say it itself
   * @return the changed options
   */
  public NodeOptions withCare(SocketFactory made, UnregisterHandler taker) {
    return new NodeOptions(threads, links, maxMessageBytes, maxHeaderBytes, handshakeTimeout, masterCheck, minBackoff,
        maxBackoff, records,
        made, taker);
  }
}
