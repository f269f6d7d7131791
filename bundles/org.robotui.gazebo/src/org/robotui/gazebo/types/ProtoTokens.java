package org.robotui.gazebo.types;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The words and signs of a definition in the language of Protocol Buffers, without its comments. */
final class ProtoTokens {
  private static final Pattern TOKEN = Pattern.compile(
      "\\s+|//[^\\n]*|/\\*(?s:.*?)\\*/|(\"[^\"\\n]*\"|'[^'\\n]*'|[.\\w][\\w.+-]*|[^\\w\\s])");
  private static final String END = "";

  private final List<String> all = new ArrayList<>();
  private int at;

  ProtoTokens(String text) {
    Matcher next = TOKEN.matcher(text);
    while (next.find()) {
      if (next.group(1) != null) {
        all.add(next.group(1));
      }
    }
  }

  /** The next one, which stays; empty at the end. */
  String peek() {
    return at < all.size() ? all.get(at) : END;
  }

  /** The one after the next. */
  String peekAfter() {
    return at + 1 < all.size() ? all.get(at + 1) : END;
  }

  String next() {
    if (at >= all.size()) {
      throw new IllegalArgumentException("the definition ends too early");
    }
    return all.get(at++);
  }

  boolean accept(String token) {
    boolean there = peek().equals(token);
    if (there) {
      at++;
    }
    return there;
  }

  void expect(String token) {
    String found = next();
    if (!found.equals(token)) {
      throw new IllegalArgumentException("'" + token + "' was expected, not '" + found + "'");
    }
  }

  int number() {
    String token = next();
    try {
      return Integer.decode(token);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("a number was expected, not '" + token + "'", e);
    }
  }

  /** Passes over a statement, with the block that belongs to it. */
  void skip() {
    int depth = 0;
    for (String token = next(); depth > 0 || !token.equals(";"); token = next()) {
      depth += token.equals("{") || token.equals("[") ? 1 : token.equals("}") || token.equals("]") ? -1 : 0;
      if (depth == 0 && token.equals("}")) {
        return;
      }
    }
  }
}
