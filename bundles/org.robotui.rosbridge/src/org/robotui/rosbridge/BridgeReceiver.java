package org.robotui.rosbridge;

/** Takes messages of a subscription. */
public interface BridgeReceiver {

  /**
   * A message has come.
   *
   * @param message the message
   * @param receivedNanos when it was received, by {@link System#nanoTime()}
   */
  void received(BridgeMessage message, long receivedNanos);

  /**
   * A message has come that nobody can read.
   *
   * @param reason why
   * @param receivedNanos when it was received, by {@link System#nanoTime()}
   */
  void unreadable(String reason, long receivedNanos);
}
