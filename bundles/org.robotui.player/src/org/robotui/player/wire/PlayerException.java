package org.robotui.player.wire;

/** Bytes that are no message of the expected kind: says what is wrong and where. */
public final class PlayerException extends Exception {

  private static final long serialVersionUID = 1L;

  /**
   * Creates the error.
   *
   * @param problem what is wrong and where, for a user to read
   */
  public PlayerException(String problem) {
    super(problem);
  }

  /**
   * The same error seen from what holds the failing part.
   *
   * @param where the part, such as {@code position2d data state.pos}
   * @return an error that begins with the place
   */
  public PlayerException within(String where) {
    PlayerException wrapped = new PlayerException(where + ": " + getMessage());
    wrapped.initCause(this);
    return wrapped;
  }
}
