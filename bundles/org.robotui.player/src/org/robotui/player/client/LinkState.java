package org.robotui.player.client;

import java.time.Duration;

/** The state of the link to a server. */
public sealed interface LinkState {

  /** Trying to reach the server. */
  record Connecting() implements LinkState {}

  /**
   * The server answered and told its devices.
   *
   * @param version the server's version, such as {@code 3.1.1-dev}
   */
  record Connected(String version) implements LinkState {}

  /**
   * The link broke or could not be made; it is tried again.
   *
   * @param reason names the server and the cause, for a user to read
   * @param retryAfter how long until the next attempt
   */
  record Failed(String reason, Duration retryAfter) implements LinkState {}

  /** The client was closed. */
  record Closed() implements LinkState {}
}
