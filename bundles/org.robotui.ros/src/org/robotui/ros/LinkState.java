package org.robotui.ros;

import java.time.Duration;
import org.robotui.message.MessageInfo;

/** The state of one link to a peer or to the master. */
public sealed interface LinkState {

  /** Trying to reach the peer. */
  record Connecting() implements LinkState {}

  /**
   * The peer answered and agreed.
   *
   * @param callerId the peer's node name
   * @param peer the message type the peer announced; {@link MessageInfo#any()} for links without one
   */
  record Connected(String callerId, MessageInfo peer) implements LinkState {}

  /**
   * The link broke or could not be made; it is tried again.
   *
   * @param reason names the peer, the topic and the cause, for a user to read
   * @param retryAfter how long until the next attempt; zero if the peer is the one to come again
   */
  record Failed(String reason, Duration retryAfter) implements LinkState {}

  /**
   * The link ended for good.
   *
   * @param reason why, for a user to read
   */
  record Closed(String reason) implements LinkState {}
}
