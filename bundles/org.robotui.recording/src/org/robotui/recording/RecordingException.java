package org.robotui.recording;

import java.io.IOException;
import java.nio.file.Path;

/** A recording cannot be read or written at all. The message names the file, the place and the cause. */
public final class RecordingException extends IOException {

  private static final long serialVersionUID = 1L;

  /**
   * Something is wrong at a place.
   *
   * @param file the recording
   * @param offset the byte at which that is
   * @param problem what is wrong
   */
  public RecordingException(Path file, long offset, String problem) {
    super(file + ", byte " + offset + ": " + problem);
  }

  /**
   * The system refuses something.
   *
   * @param file the recording
   * @param what was tried, such as "cannot be opened"
   * @param cause what the system says
   */
  public RecordingException(Path file, String what, IOException cause) {
    super(file + " " + what + ": " + cause.getMessage() + " (" + cause.getClass().getSimpleName() + ")", cause);
  }
}
