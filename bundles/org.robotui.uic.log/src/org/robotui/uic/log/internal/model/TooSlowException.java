package org.robotui.uic.log.internal.model;

/** A regular expression needed more steps than it is given. */
final class TooSlowException extends RuntimeException {
  private static final long serialVersionUID = 1;

  TooSlowException() {
    super("the expression takes too long", null, false, false);
  }
}
