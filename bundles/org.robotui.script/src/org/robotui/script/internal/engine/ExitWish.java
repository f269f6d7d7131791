package org.robotui.script.internal.engine;

/** A script has asked for its end. It cannot be caught by the script. */
public final class ExitWish extends Error {
  private static final long serialVersionUID = 1L;

  private final int code;

  /** The end with a code for who started the script. */
  public ExitWish(int code) {
    super("exit(" + code + ")", null, false, false);
    this.code = code;
  }

  int code() {
    return code;
  }
}
