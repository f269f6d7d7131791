package org.robotui.rfic.recording.internal.compare;

/** Recordings cannot be compared as it was asked for. The message says why, and what can be done. */
public final class CompareException extends Exception {
  private static final long serialVersionUID = 1;

  /**
   * Says why.
   *
   * @param message a sentence for users
   */
  public CompareException(String message) {
    super(message);
  }
}
