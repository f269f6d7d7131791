package org.robotui.smartsoft.wire;

import java.io.IOException;

/** Bytes that are no message of SmartSoft, or not the one that was expected. */
public final class SmartSoftException extends IOException {

  private static final long serialVersionUID = 1;

  /**
   * With a reason.
   *
   * @param message for users
   */
  public SmartSoftException(String message) {
    super(message);
  }
}
