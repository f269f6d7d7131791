package org.robotui.urdf.internal;

/** A text or file cannot be used. */
public final class Refusal extends Exception {
  private static final long serialVersionUID = 1;

  private final int line;

  /** Says why, and in which line; 0 for none. */
  public Refusal(int line, String why) {
    super(why);
    this.line = line;
  }

  /** From 1, or 0. */
  public int line() {
    return line;
  }
}
