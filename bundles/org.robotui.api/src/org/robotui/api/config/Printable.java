package org.robotui.api.config;

/**
 * Text that came from a file or a network, made harmless for a terminal: characters that would steer it, break the line
 * or turn the direction of writing are shown as {@code \}{@code u001b}. This is the one place that knows which they
 * are.
 */
public final class Printable {
  private static final String BIDIRECTIONAL = "\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069";
  private static final String ELLIPSIS = "\u2026";

  private Printable() {}

  /**
   * Whether a text can be shown as it is.
   *
   * @param text any text
   * @return true where nothing in it steers a terminal
   */
  public static boolean isPlain(String text) {
    return text.codePoints().allMatch(Printable::isPlain);
  }

  /**
   * Shows what steers.
   *
   * @param text any text
   * @return the text in one line; itself where it is plain
   */
  public static String of(String text) {
    if (isPlain(text)) {
      return text;
    }
    StringBuilder shown = new StringBuilder();
    text.codePoints().forEach(c -> {
      if (isPlain(c)) {
        shown.appendCodePoint(c);
      } else {
        shown.append(String.format("\\u%04x", c));
      }
    });
    return shown.toString();
  }

  /**
   * The beginning of a text, for messages.
   *
   * @param text any text
   * @param most how many characters, at least 1
   * @return the text in one line, cut where it is longer
   */
  public static String beginning(String text, int most) {
    int length = text.codePointCount(0, text.length());
    return of(length <= most ? text : text.substring(0, text.offsetByCodePoints(0, most - 1)) + ELLIPSIS);
  }

  private static boolean isPlain(int c) {
    int type = Character.getType(c);
    return type != Character.CONTROL && type != Character.SURROGATE && type != Character.LINE_SEPARATOR
        && type != Character.PARAGRAPH_SEPARATOR && BIDIRECTIONAL.indexOf(c) < 0;
  }
}
