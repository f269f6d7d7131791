package org.robotui.carmen.format;

import java.io.IOException;

/** What a peer sent is none of IPC, or does not fit its format. The message is for users to read. */
public final class IpcFormatException extends IOException {

  private static final long serialVersionUID = 1;

  /**
   * Says what is wrong.
   *
   * @param message names the place and what was expected
   */
  public IpcFormatException(String message) {
    super(message);
  }
}
