package org.robotui.ros;

/** A service refuses a call; the message is sent to the client. */
public final class ServiceException extends Exception {

  private static final long serialVersionUID = 1L;

  /**
   * Creates the refusal.
   *
   * @param message why, for the client's user to read
   */
  public ServiceException(String message) {
    super(message);
  }
}
