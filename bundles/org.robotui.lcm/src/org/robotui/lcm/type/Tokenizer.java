package org.robotui.lcm.type;

/** Cuts a {@code .lcm} file into words and signs, without white space and comments. */
final class Tokenizer {

  private static final String SIGNS = "{}[]();,=";

  private final String file;
  private final String text;
  private int at;
  private int line = 1;
  private int lineStart;

  Tokenizer(String file, String text) {
    this.file = file;
    this.text = text;
  }

  Token next() throws TypeException {
    skipWhatSaysNothing();
    Place place = place();
    if (at == text.length()) {
      return new Token("", place);
    }
    int start = at++;
    if (SIGNS.indexOf(text.charAt(start)) < 0) {
      while (at < text.length() && isOfWord(text.charAt(at)) && !startsComment()) {
        at++;
      }
    }
    return new Token(text.substring(start, at), place);
  }

  private void skipWhatSaysNothing() throws TypeException {
    while (at < text.length()) {
      if (Character.isWhitespace(text.charAt(at))) {
        step();
      } else if (text.startsWith("//", at)) {
        int end = text.indexOf('\n', at);
        at = end < 0 ? text.length() : end;
      } else if (text.startsWith("/*", at)) {
        skipComment();
      } else {
        return;
      }
    }
  }

  private void skipComment() throws TypeException {
    Place start = place();
    int end = text.indexOf("*/", at + 2);
    if (end < 0) {
      throw new TypeException(start, "this comment has no end", "write */ where it ends");
    }
    while (at < end + 2) {
      step();
    }
  }

  private void step() {
    if (text.charAt(at++) == '\n') {
      line++;
      lineStart = at;
    }
  }

  private boolean startsComment() {
    return text.startsWith("//", at) || text.startsWith("/*", at);
  }

  private static boolean isOfWord(char c) {
    return !Character.isWhitespace(c) && SIGNS.indexOf(c) < 0;
  }

  private Place place() {
    return new Place(file, line, at - lineStart + 1);
  }
}
