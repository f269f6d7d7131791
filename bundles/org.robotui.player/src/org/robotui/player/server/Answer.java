package org.robotui.player.server;

import java.nio.ByteBuffer;

/** What a device answers to a request. */
public sealed interface Answer {

  /**
   * It was done.
   *
   * @param payload the answer's body
   */
  record Ack(ByteBuffer payload) implements Answer {}

  /**
   * It is refused.
   *
   * @param payload the body; most drivers send none
   */
  record Nack(ByteBuffer payload) implements Answer {}

  /** Nothing is said, as some drivers do; the client waits in vain. */
  record Silence() implements Answer {}

  /**
   * A refusal without a body.
   *
   * @return the answer
   */
  static Answer refused() {
    return new Nack(ByteBuffer.allocate(0));
  }
}
