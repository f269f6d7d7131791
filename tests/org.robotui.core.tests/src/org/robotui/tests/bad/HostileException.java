package org.robotui.tests.bad;

/** Throws again where it is asked what it is. */
final class HostileException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  @Override
  public String getMessage() {
    throw new StackOverflowError();
  }
}
