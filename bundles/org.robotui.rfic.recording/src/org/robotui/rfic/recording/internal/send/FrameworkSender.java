package org.robotui.rfic.recording.internal.send;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import org.robotui.recording.RecordedMessage;

/** Sends messages into a framework, as they were recorded. For one thread. */
interface FrameworkSender extends AutoCloseable {
  /**
   * Sends a message of one of the channels for which it was made.
   *
   * @throws IOException if it cannot be sent
   */
  void send(RecordedMessage message) throws IOException;

  /**
   * Says what time it is, where the framework has a message for that.
   *
   * @param nanos since 1970
   */
  void clock(long nanos);

  /** Whether somebody listens to each topic, as far as the framework knows; true where it does not. */
  boolean isHeard();

  /** Waits for a moment until what was sent has left. */
  void finish();

  /** Where it is to be found, for users who have to connect to it; nothing where they meet elsewhere. */
  default List<String> places() {
    return List.of();
  }

  @Override
  void close();

  /** The bytes of a message for who keeps what it sends: it must not keep the whole chunk that they lie in. */
  static ByteBuffer copy(ByteBuffer data) {
    return ByteBuffer.allocate(data.remaining()).put(data.duplicate()).flip();
  }
}
