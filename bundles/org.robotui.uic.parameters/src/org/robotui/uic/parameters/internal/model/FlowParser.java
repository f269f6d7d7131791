package org.robotui.uic.parameters.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.api.input.TypedText;
import org.robotui.api.input.Unreadable;

/** Reads lists and maps in one line, as YAML and JSON write them. Bounded in depth and length. */
final class FlowParser {
  private static final int DEEPEST = 32;
  private static final int LONGEST = 100_000;
  private static final String ENDS = ",]}";

  private final String text;
  private int at;

  private FlowParser(String text) {
    this.text = text;
  }

  static Object parse(String text) throws Unreadable {
    if (text.length() > LONGEST) {
      throw new Unreadable("More than " + LONGEST + " characters are too many");
    }
    FlowParser parser = new FlowParser(text);
    Object value = parser.value(0);
    parser.skip();
    if (parser.at < text.length()) {
      throw parser.expected("the end");
    }
    return value;
  }

  private Object value(int depth) throws Unreadable {
    if (depth > DEEPEST) {
      throw new Unreadable("More than " + DEEPEST + " lists within lists are too many");
    }
    skip();
    return switch (peek()) {
      case '[' -> list(depth);
      case '{' -> map(depth);
      case '"', '\'' -> quoted();
      default -> scalar(plain(ENDS));
    };
  }

  private List<Object> list(int depth) throws Unreadable {
    List<Object> values = new ArrayList<>();
    at++;
    skip();
    while (peek() != ']') {
      values.add(value(depth + 1));
      separator(']');
    }
    at++;
    return values;
  }

  private Map<String, Object> map(int depth) throws Unreadable {
    Map<String, Object> values = new LinkedHashMap<>();
    at++;
    skip();
    while (peek() != '}') {
      String key = peek() == '"' || peek() == '\'' ? quoted() : plain(":" + ENDS);
      skip();
      if (peek() != ':') {
        throw expected("':' after '" + key + "'");
      }
      at++;
      if (values.put(key, value(depth + 1)) != null) {
        throw new Unreadable("'" + key + "' stands there twice");
      }
      separator('}');
    }
    at++;
    return values;
  }

  private void separator(char end) throws Unreadable {
    skip();
    if (peek() == ',') {
      at++;
      skip();
    } else if (peek() != end) {
      throw expected("',' or '" + end + "'");
    }
  }

  private String quoted() throws Unreadable {
    char quote = text.charAt(at);
    int begin = at++;
    StringBuilder value = new StringBuilder();
    while (at < text.length() && text.charAt(at) != quote) {
      value.append(quote == '"' && text.charAt(at) == '\\' ? escaped() : text.charAt(at));
      at++;
    }
    if (at >= text.length()) {
      throw new Unreadable("The quote at character " + (begin + 1) + " is never closed");
    }
    at++;
    return value.toString();
  }

  private char escaped() throws Unreadable {
    at++;
    return switch (peek()) {
      case 'n' -> '\n';
      case 't' -> '\t';
      case 'r' -> '\r';
      case '"', '\\', '/' -> peek();
      default -> throw expected("one of n t r \" \\ after the backslash");
    };
  }

  private String plain(String ends) throws Unreadable {
    int begin = at;
    while (at < text.length() && ends.indexOf(text.charAt(at)) < 0) {
      at++;
    }
    String word = text.substring(begin, at).strip();
    if (word.isEmpty()) {
      throw expected("a value");
    }
    return word;
  }

  private static Object scalar(String word) throws Unreadable {
    if (word.equals("true") || word.equals("false")) {
      return Boolean.valueOf(word);
    }
    try {
      return TypedText.whole(word);
    } catch (Unreadable notWhole) {
      if (word.matches("[-+]?0\\d+")) {
        throw new Unreadable("'" + word + "' " + notWhole.getMessage());
      }
      return realOrText(word);
    }
  }

  private static Object realOrText(String word) {
    boolean number = Character.isDigit(word.charAt(word.length() - 1)) || word.endsWith(".") || word.endsWith(".inf")
        || word.equals(".nan");
    try {
      return number ? (Object) TypedText.real(word) : word;
    } catch (Unreadable notReal) {
      return word;
    }
  }

  private void skip() {
    while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
      at++;
    }
  }

  /** The next character, or one that nothing begins with. */
  private char peek() {
    return at < text.length() ? text.charAt(at) : '\0';
  }

  private Unreadable expected(String what) {
    return new Unreadable(at < text.length()
        ? what + " is expected at character " + (at + 1) + ", there is '" + text.charAt(at) + "'"
        : what + " is expected at the end");
  }
}
