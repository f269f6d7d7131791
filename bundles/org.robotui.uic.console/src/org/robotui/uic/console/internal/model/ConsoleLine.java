package org.robotui.uic.console.internal.model;

/**
 * Something that stands in the console.
 *
 * @param kind what it is
 * @param text one or more lines
 */
public record ConsoleLine(Kind kind, String text) {
  private static final String TYPED = "> ";
  private static final String GOES_ON = "\n  ";

  /** What stands in a console. */
  public enum Kind {
    /** What the user typed. */
    INPUT,
    /** What the user did elsewhere, as a line of a script. */
    RECORDED,
    /** What a script printed. */
    OUTPUT,
    /** What it came to. */
    VALUE,
    /** Why it failed or was stopped. */
    ERROR,
    /** What the console itself says. */
    NOTE
  }

  /** As it is shown and copied: what was typed is marked. */
  public String shown() {
    return kind == Kind.INPUT ? TYPED + text.replace("\n", GOES_ON) : text;
  }
}
