package org.robotui.uic.text.internal;

/**
 * Text in the columns of a terminal. What comes from a robot is hostile: a character that would move the cursor, change
 * colours or turn the direction of writing is shown as its number.
 */
final class Columns {
  private static final String ELLIPSIS = "\u2026";
  private static final int[][] WIDE = {
      {0x1100, 0x115f}, {0x2e80, 0xa4cf}, {0xac00, 0xd7a3}, {0xf900, 0xfaff}, {0xfe30, 0xfe6f}, {0xff00, 0xff60},
      {0xffe0, 0xffe6}, {0x1f300, 0x1faff}, {0x20000, 0x3fffd}};

  private Columns() {}

  /** The text without anything that a terminal would obey. */
  static String safe(String text) {
    StringBuilder safe = new StringBuilder(text.length());
    text.codePoints().forEach(c -> {
      if (printable(c)) {
        safe.appendCodePoint(c);
      } else {
        safe.append(c == '\n' || c == '\r' || c == '\t' ? " " : String.format("\\u%04x", c));
      }
    });
    return safe.toString();
  }

  private static boolean printable(int c) {
    return switch (Character.getType(c)) {
      case Character.CONTROL, Character.FORMAT, Character.SURROGATE, Character.PRIVATE_USE, Character.UNASSIGNED,
          Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR -> false;
      default -> true;
    };
  }

  /** How many columns a safe text takes. */
  static int width(String text) {
    return text.codePoints().map(Columns::width).sum();
  }

  private static int width(int c) {
    int type = Character.getType(c);
    if (type == Character.NON_SPACING_MARK || type == Character.ENCLOSING_MARK) {
      return 0;
    }
    for (int[] range : WIDE) {
      if (c >= range[0] && c <= range[1]) {
        return 2;
      }
    }
    return 1;
  }

  /** The text in at most that many columns, with an ellipsis where it was cut. */
  static String cut(String text, int columns) {
    if (width(text) <= columns) {
      return text;
    }
    StringBuilder cut = new StringBuilder();
    int used = 1;
    for (int c : text.codePoints().toArray()) {
      used += width(c);
      if (used > columns) {
        break;
      }
      cut.appendCodePoint(c);
    }
    return columns < 1 ? "" : cut + ELLIPSIS;
  }

  /** The text in exactly that many columns, at the left. */
  static String left(String text, int columns) {
    String cut = cut(text, columns);
    return cut + " ".repeat(columns - width(cut));
  }

  /** The text in exactly that many columns, at the right. */
  static String right(String text, int columns) {
    String cut = cut(text, columns);
    return " ".repeat(columns - width(cut)) + cut;
  }

  /** Two texts at the ends of a line; the right one is kept whole before the left one. */
  static String spread(String left, String right, int columns) {
    int room = columns - width(right) - 2;
    return room > 0 ? left(left, room) + "  " + right : cut(right, columns);
  }
}
