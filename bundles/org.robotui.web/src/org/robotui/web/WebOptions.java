package org.robotui.web;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.ThreadFactory;

/**
 * How a link is opened, and its bounds.
 *
 * @param threads makes the threads of the link
 * @param subprotocols those that are offered, the most wanted first; may be empty
 * @param connecting at most so long until the peer has answered
 * @param longest most bytes (or characters) of a message that is received; a longer one is passed over
 */
public record WebOptions(ThreadFactory threads, List<String> subprotocols, Duration connecting, int longest) {

  private static final Duration CONNECTING = Duration.ofMillis(1500);
  private static final int LONGEST = 1 << 26;

  /** Copies the list. */
  public WebOptions {
    subprotocols = List.copyOf(subprotocols);
    if (longest < 1) {
      throw new IllegalArgumentException("messages of at most " + longest + " bytes");
    }
  }

  /**
   * One and a half seconds to connect, messages of at most 64 MiB.
   *
   * @param threads makes the threads of the link
   * @param subprotocols those that are offered
   * @return the options
   */
  public static WebOptions standard(ThreadFactory threads, String... subprotocols) {
    return new WebOptions(threads, List.of(subprotocols), CONNECTING, LONGEST);
  }

  /**
   * The same with another bound.
   *
   * @param bytes most bytes of a message that is received
   * @return the options
   */
  public WebOptions withLongest(int bytes) {
    return new WebOptions(threads, subprotocols, connecting, bytes);
  }
}
