package org.robotui.api.input;

/** Text that is no value. The message is for the user; what throws says whether it is a whole sentence. */
public final class Unreadable extends Exception {
  private static final long serialVersionUID = 1;

  /**
   * Says what is wrong.
   *
   * @param message words for the user
   */
  public Unreadable(String message) {
    super(message, null, false, false);
  }
}
