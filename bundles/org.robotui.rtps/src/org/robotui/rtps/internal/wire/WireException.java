package org.robotui.rtps.internal.wire;

/** Bytes that are no RTPS. It has no stack trace, as peers cause it as often as they like. */
public final class WireException extends Exception {

  private static final long serialVersionUID = 1;

  /**
   * Names what is wrong.
   *
   * @param message what and where; the caller knows from whom
   */
  public WireException(String message) {
    super(message, null, false, false);
  }
}
