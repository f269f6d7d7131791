package org.robotui.roboframe.wire;

import java.nio.ByteBuffer;
import java.util.List;

/** What one broker says to another one. */
public sealed interface BrokerMessage {

  /**
   * The first message of both sides.
   *
   * @param version of the wire
   * @param application its name
   */
  record Hello(int version, String application) implements BrokerMessage {}

  /**
   * All keys that an application uses, in place of what it said before.
   *
   * @param keys by no order
   */
  record Board(List<BoardKey> keys) implements BrokerMessage {

    /** Takes a copy. */
    public Board {
      keys = List.copyOf(keys);
    }
  }

  /**
   * A value of a key that the receiver reads.
   *
   * @param key its name
   * @param stampNanos when it was written, nanoseconds since the epoch of the sender's clock
   * @param count how many were written of the key before it, by the sender
   * @param bytes the value
   */
  record Value(String key, long stampNanos, long count, ByteBuffer bytes) implements BrokerMessage {}

  /**
   * Asks whether the other side is there.
   *
   * @param token is answered
   */
  record Ping(long token) implements BrokerMessage {}

  /**
   * The answer.
   *
   * @param token of the question
   */
  record Pong(long token) implements BrokerMessage {}
}
