package org.robotui.rfic.recording.internal.send;

import java.io.IOException;
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

  @Override
  void close();
}
