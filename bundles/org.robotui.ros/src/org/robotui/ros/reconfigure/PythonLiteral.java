package org.robotui.ros.reconfigure;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads the text of a Python value as data: dictionaries, lists and tuples of texts, numbers, truth values and None.
 * The text comes from a peer: nothing is evaluated, and its length, its depth and the number of its elements are
 * bounded.
 */
final class PythonLiteral {

  static final int MAX_TEXT = 256 * 1024;
  private static final int MAX_DEPTH = 16;
  private static final int MAX_ELEMENTS = 20_000;

  private final String text;
  private int at;
  private int depth;
  private int elements;

  private PythonLiteral(String text) {
    this.text = text;
  }

  /** The text is no such value. */
  static final class SyntaxException extends Exception {
    private static final long serialVersionUID = 1L;

    SyntaxException(String message) {
      super(message);
    }
  }

  /** A map, a list, a string, a {@link Long}, a {@link Double}, a {@link Boolean}, or an empty Optional for None. */
  static Object parse(String text) throws SyntaxException {
    if (text.length() > MAX_TEXT) {
      throw new SyntaxException("a text of " + text.length() + " characters is too long");
    }
    PythonLiteral parser = new PythonLiteral(text);
    Object value = parser.value();
    parser.skipBlanks();
    if (parser.at < text.length()) {
      throw parser.error("the end");
    }
    return value;
  }

  private Object value() throws SyntaxException {
    skipBlanks();
    if (++elements > MAX_ELEMENTS || ++depth > MAX_DEPTH) {
      throw new SyntaxException("too many or too deeply nested elements");
    }
    Object value = switch (peek()) {
      case '{' -> map();
      case '[' -> list(']');
      case '(' -> list(')');
      case '\'', '"' -> string();
      default -> word();
    };
    depth--;
    return value;
  }

  private Map<Object, Object> map() throws SyntaxException {
    Map<Object, Object> map = new LinkedHashMap<>();
    at++;
    while (!closes('}')) {
      Object key = value();
      expect(':');
      map.put(key, value());
      separate('}');
    }
    return map;
  }

  private List<Object> list(char end) throws SyntaxException {
    List<Object> list = new ArrayList<>();
    at++;
    while (!closes(end)) {
      list.add(value());
      separate(end);
    }
    return list;
  }

  private boolean closes(char end) {
    skipBlanks();
    boolean there = peek() == end;
    at += there ? 1 : 0;
    return there;
  }

  private void separate(char end) throws SyntaxException {
    skipBlanks();
    if (peek() != end) {
      expect(',');
    }
  }

  private void expect(char c) throws SyntaxException {
    skipBlanks();
    if (peek() != c) {
      throw error("'" + c + "'");
    }
    at++;
  }

  private void skipBlanks() {
    while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
      at++;
    }
  }

  /** The next character; NUL at the end, which belongs to nothing. */
  private char peek() {
    return at < text.length() ? text.charAt(at) : '\0';
  }

  private String string() throws SyntaxException {
    char quote = text.charAt(at++);
    StringBuilder out = new StringBuilder();
    while (at < text.length() && text.charAt(at) != quote) {
      char c = text.charAt(at++);
      if (c == '\\') {
        escape(out);
      } else {
        out.append(c);
      }
    }
    expect(quote);
    return out.toString();
  }

  private void escape(StringBuilder out) throws SyntaxException {
    char c = peek();
    at++;
    switch (c) {
      case 'n' -> out.append('\n');
      case 't' -> out.append('\t');
      case 'r' -> out.append('\r');
      case 'x' -> out.append((char) hex(2));
      case 'u' -> out.append((char) hex(4));
      case 'U' -> wide(out);
      case '\\', '\'', '"' -> out.append(c);
      default -> out.append('\\').append(c);
    }
  }

  private void wide(StringBuilder out) throws SyntaxException {
    int codePoint = hex(8);
    if (!Character.isValidCodePoint(codePoint)) {
      throw error("a character's number");
    }
    out.appendCodePoint(codePoint);
  }

  private int hex(int digits) throws SyntaxException {
    int end = Math.min(text.length(), at + digits);
    try {
      int value = Integer.parseUnsignedInt(text.substring(Math.min(at, end), end), 16);
      at = end;
      return value;
    } catch (NumberFormatException e) {
      throw error(digits + " hexadecimal digits");
    }
  }

  /** A number, a truth value, None, or a string with a prefix such as in {@code u'text'}. */
  private Object word() throws SyntaxException {
    int begin = at;
    while (at < text.length() && (Character.isLetterOrDigit(text.charAt(at)) || "+-._".indexOf(text.charAt(at)) >= 0)) {
      at++;
    }
    String word = text.substring(begin, at);
    return switch (word) {
      case "True" -> true;
      case "False" -> false;
      case "None" -> Optional.empty();
      case "u", "b", "r" -> peek() == '\'' || peek() == '"' ? string() : number(word, begin);
      default -> number(word, begin);
    };
  }

  private Object number(String word, int begin) throws SyntaxException {
    try {
      if (word.matches("[+-]?\\d{1,18}[lL]?")) {
        return Long.parseLong(word.replaceFirst("[lL]$", ""));
      }
      if (word.matches("[+-]?(inf|nan)")) {
        return word.endsWith("nan") ? Double.NaN
            : word.startsWith("-") ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
      }
      if (word.matches("[+-]?[\\d.][\\d.eE+-]{0,40}")) {
        return Double.parseDouble(word);
      }
    } catch (NumberFormatException e) {
      at = begin;
      throw error("a number");
    }
    at = begin;
    throw error("a value");
  }

  private SyntaxException error(String expected) {
    String rest = text.substring(Math.min(at, text.length()), Math.min(text.length(), at + 20));
    return new SyntaxException(
        "expected " + expected + " at position " + (at + 1) + (rest.isEmpty() ? "" : ", found '" + rest + "'"));
  }
}
