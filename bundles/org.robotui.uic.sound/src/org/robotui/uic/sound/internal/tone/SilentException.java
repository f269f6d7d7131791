package org.robotui.uic.sound.internal.tone;

/** Nothing can be heard. The message says why, and what would help. */
public final class SilentException extends Exception {
  private static final long serialVersionUID = 1;

  /** Says why. */
  public SilentException(String message, Throwable cause) {
    super(message, cause);
  }

  /** Says why, where nothing was thrown. */
  public SilentException(String message) {
    super(message);
  }
}
