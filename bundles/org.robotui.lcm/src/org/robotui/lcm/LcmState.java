package org.robotui.lcm;

import java.time.Duration;

/** How it stands with a connection. */
public sealed interface LcmState {

  /** It is being opened. */
  record Connecting() implements LcmState {}

  /**
   * Messages can come and go.
   *
   * @param where what was reached, and how
   */
  record Connected(String where) implements LcmState {}

  /**
   * It could not be opened, or broke.
   *
   * @param reason names the address and the cause, for a user to read
   * @param retryAfter when it is tried again
   */
  record Failed(String reason, Duration retryAfter) implements LcmState {}

  /**
   * Nothing more will come, as at the end of a log.
   *
   * @param reason for a user to read
   */
  record Ended(String reason) implements LcmState {}

  /** Its owner closed it. */
  record Closed() implements LcmState {}
}
