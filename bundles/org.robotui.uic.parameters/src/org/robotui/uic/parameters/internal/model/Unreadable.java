package org.robotui.uic.parameters.internal.model;

/** Typed text that is no value; the message tells the user what is wrong. */
public final class Unreadable extends Exception {
  private static final long serialVersionUID = 1L;

  /** With what is wrong. */
  public Unreadable(String message) {
    super(message);
  }
}
