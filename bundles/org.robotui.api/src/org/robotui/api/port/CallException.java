package org.robotui.api.port;

/** A request that cannot be answered. The message is for the user and names the cause. */
public final class CallException extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * With a message.
   *
   * @param message names the cause
   */
  public CallException(String message) {
    super(message);
  }

  /**
   * With a message and what led to it.
   *
   * @param message names the cause
   * @param cause what led to it
   */
  public CallException(String message, Throwable cause) {
    super(message, cause);
  }
}
