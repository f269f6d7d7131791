package org.robotui.yarp.bottle;

import java.io.IOException;

/** What came is not what YARP sends; the message says what was expected. */
public final class YarpFormatException extends IOException {
  private static final long serialVersionUID = 1L;

  /**
   * Says what is wrong.
   *
   * @param message for a user to read
   */
  public YarpFormatException(String message) {
    super(message);
  }
}
