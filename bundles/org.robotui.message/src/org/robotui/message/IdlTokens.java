package org.robotui.message;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The words of a file in IDL, without comments and what is for a preprocessor. */
final class IdlTokens {

  private static final Pattern TOKEN = Pattern.compile("""
      \\s+|//[^\\n]*|/\\*.*?\\*/|\\#[^\\n]*\
      |(?<word>"(?:[^"\\\\]|\\\\.)*+"|'[^']{1,8}'|(?:::)?\\w+(?:::\\w+)*|[-+]?[\\d.][\\w.+-]*|[^\\s\\w])""",
      Pattern.DOTALL);

  private final String type;
  private final List<String> words;
  private int next;

  IdlTokens(String type, String text) throws DefinitionException {
    this.type = type;
    this.words = new ArrayList<>();
    Matcher matcher = TOKEN.matcher(text);
    int end = 0;
    while (end < text.length() && matcher.find(end) && matcher.start() == end) {
      if (matcher.group("word") != null) {
        words.add(matcher.group("word"));
      }
      end = matcher.end();
    }
    if (end < text.length()) {
      throw new DefinitionException(type, "the text is no IDL at character " + (end + 1));
    }
  }

  boolean more() {
    return next < words.size();
  }

  String peek() {
    return more() ? words.get(next) : "";
  }

  String take() throws DefinitionException {
    if (!more()) {
      throw new DefinitionException(type, "the text in IDL ends too early");
    }
    return words.get(next++);
  }

  boolean takeIf(String word) {
    boolean same = peek().equals(word);
    next += same ? 1 : 0;
    return same;
  }

  void expect(String word) throws DefinitionException {
    String found = take();
    if (!found.equals(word)) {
      throw new DefinitionException(type, "expected '" + word + "' in IDL, found '" + found + "'");
    }
  }

  DefinitionException unsupported(String what) {
    return new DefinitionException(type, what + " in IDL is not supported");
  }
}
