package org.robotui.foxglove;

import java.nio.ByteBuffer;

/** Takes messages of a subscription. */
@FunctionalInterface
public interface MessageReceiver {

  /**
   * A message has come.
   *
   * @param payload in the encoding of its channel; nobody writes to it again
   * @param nanos when the server had it, by the server's clock
   * @param receivedNanos when it was received, by {@link System#nanoTime()}
   */
  void received(ByteBuffer payload, long nanos, long receivedNanos);
}
