package org.robotui.uic.console.internal.model;

/** Whether a text goes on: where a bracket, a template or a comment is still open, Enter begins a new line. */
public final class OpenBrackets {
  private final String text;
  private int at;
  private int depth;
  private boolean open;

  private OpenBrackets(String text) {
    this.text = text;
  }

  /** Whether something is open at the end. Never where a bracket is closed that was not opened: that is an error. */
  public static boolean in(String text) {
    return new OpenBrackets(text).isOpen();
  }

  private boolean isOpen() {
    while (at < text.length() && !open && depth >= 0) {
      step(text.charAt(at));
    }
    return open || depth > 0;
  }

  private void step(char c) {
    switch (c) {
      case '(', '[', '{' -> depth++;
      case ')', ']', '}' -> depth--;
      case '"', '\'' -> skip(c, true);
      case '`' -> open = !skip(c, false);
      case '/' -> comment();
      default -> {}
    }
    at++;
  }

  /** Goes to the end of a literal: a text ends with its line at the latest, which is for the engine to say. */
  private boolean skip(char quote, boolean inLine) {
    for (at++; at < text.length(); at++) {
      char c = text.charAt(at);
      if (c == quote || inLine && c == '\n') {
        return true;
      }
      if (c == '\\') {
        at++;
      }
    }
    return false;
  }

  private void comment() {
    if (text.startsWith("//", at)) {
      int end = text.indexOf('\n', at);
      at = end < 0 ? text.length() : end;
    } else if (text.startsWith("/*", at)) {
      int end = text.indexOf("*/", at + 2);
      open = end < 0;
      at = end + 1;
    }
  }
}
