package org.robotui.player.server;

import java.net.InetAddress;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import java.util.function.DoubleSupplier;

/**
 * What a server is given by its owner.
 *
 * @param threads makes a thread that accepts, and two for each client
 * @param bind where it listens
 * @param port the port, by custom 6665; 0 for a free one
 * @param version what it greets with
 * @param key what clients must say before anything else; none if empty
 * @param clock the stamp of answers, seconds
 * @param maxClients more are closed at once
 * @param maxQueued how many data may wait for one client; older ones are dropped, and the client is told
 * @param messageTime for the rest of a message that has begun
 */
public record ServerOptions(ThreadFactory threads, InetAddress bind, int port, String version, Optional<byte[]> key,
    DoubleSupplier clock,
    int maxClients, int maxQueued, Duration messageTime) {

  /** Checks the bounds. */
  public ServerOptions {
    Objects.requireNonNull(threads, "threads");
    Objects.requireNonNull(bind, "bind");
    if (port < 0 || port > 0xffff || maxClients < 1 || maxQueued < 1) {
      throw new IllegalArgumentException("port " + port + ", " + maxClients + " clients, " + maxQueued + " messages");
    }
  }

  /**
   * On loopback, without a key, 64 clients, 1024 messages for each, 5 s for a message.
   *
   * @param threads makes the threads
   * @param port the port
   * @param clock the stamp of answers, seconds
   * @return the default
   */
  public static ServerOptions loopback(ThreadFactory threads, int port, DoubleSupplier clock) {
    return new ServerOptions(threads, InetAddress.getLoopbackAddress(), port, "3.1.0-robotui", Optional.empty(), clock,
        64, 1024,
        Duration.ofSeconds(5));
  }

  /**
   * The same options with a key.
   *
   * @param bytes at most 32
   * @return the changed options
   */
  public ServerOptions withKey(byte[] bytes) {
    return new ServerOptions(threads, bind, port, version, Optional.of(bytes.clone()), clock, maxClients, maxQueued,
        messageTime);
  }

  /**
   * The same options with other bounds.
   *
   * @param clients how many at most
   * @param queued how many data may wait for one
   * @param message for the rest of a message
   * @return the changed options
   */
  public ServerOptions withBounds(int clients, int queued, Duration message) {
    return new ServerOptions(threads, bind, port, version, key, clock, clients, queued, message);
  }
}
