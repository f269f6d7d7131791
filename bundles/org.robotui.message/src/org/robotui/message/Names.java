package org.robotui.message;

import java.util.ArrayList;
import java.util.List;

/**
 * Words and names of definitions. Some hundred definitions are read before the first picture: patterns and streams,
 * which have to be made and linked first, take longer for that than plain code.
 */
final class Names {

  private Names() {}

  /** A letter, then letters, digits and underscores. */
  static boolean isName(String text) {
    return isName(text, 0, text.length());
  }

  private static boolean isName(String text, int from, int to) {
    if (from >= to || !isLetter(text.charAt(from))) {
      return false;
    }
    for (int i = from + 1; i < to; i++) {
      char c = text.charAt(i);
      if (!isLetter(c) && !isDigit(c) && c != '_') {
        return false;
      }
    }
    return true;
  }

  /** A package and a type in it. */
  static boolean isFullName(String text) {
    int slash = text.indexOf('/');
    return slash > 0 && isName(text, 0, slash) && isName(text, slash + 1, text.length());
  }

  /** One to nine digits. */
  static boolean isCount(String text, int from, int to) {
    if (to - from < 1 || to - from > 9) {
      return false;
    }
    for (int i = from; i < to; i++) {
      if (!isDigit(text.charAt(i))) {
        return false;
      }
    }
    return true;
  }

  /** What stands between white space; the last of so many words is all that is left. */
  static List<String> words(String text, int most) {
    List<String> words = new ArrayList<>();
    int start = 0;
    for (int end = nextSpace(text, 0); end < text.length() && words.size() < most - 1; end = nextSpace(text, start)) {
      words.add(text.substring(start, end));
      start = end;
      while (start < text.length() && isSpace(text.charAt(start))) {
        start++;
      }
    }
    words.add(text.substring(start));
    return words;
  }

  private static int nextSpace(String text, int from) {
    int i = from;
    while (i < text.length() && !isSpace(text.charAt(i))) {
      i++;
    }
    return i;
  }

  private static boolean isSpace(char c) {
    return c == ' ' || c >= '\t' && c <= '\r';
  }

  private static boolean isLetter(char c) {
    return c >= 'a' && c <= 'z' || c >= 'A' && c <= 'Z';
  }

  private static boolean isDigit(char c) {
    return c >= '0' && c <= '9';
  }
}
