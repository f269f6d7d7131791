package org.robotui.lcm;

/** Hears of messages. */
@FunctionalInterface
public interface LcmListener {

  /**
   * A message came in. Called on the receiving thread, where it must not block, or on the thread of the subscription's
   * queue; one call at a time for each subscription. What it throws is logged and counted, and the rest goes on.
   *
   * @param message the message
   */
  void onMessage(LcmMessage message);
}
