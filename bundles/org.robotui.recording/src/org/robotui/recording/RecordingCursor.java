package org.robotui.recording;

import java.util.Optional;

/**
 * Gives messages one after another in order of their log times. For one thread; it holds nothing that must be closed.
 */
public interface RecordingCursor {

  /**
   * The next message. Messages of one time come in the order in which they lie in the file. What is damaged is left
   * out, and told by {@link RecordingReader#damages}.
   *
   * @return the message; empty at the end of what was asked for
   * @throws RecordingException if the file cannot be read any more
   */
  Optional<RecordedMessage> next() throws RecordingException;
}
