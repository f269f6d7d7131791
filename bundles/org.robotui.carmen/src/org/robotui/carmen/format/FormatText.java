package org.robotui.carmen.format;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Reads formats as programs write them, such as {@code {int, <byte:1>}}. For one thread. */
public final class FormatText {

  private static final int DEEPEST = 32;
  private static final int LONGEST = 1 << 16;

  private final String text;
  private int at;
  private int depth;

  private FormatText(String text) {
    this.text = text;
  }

  /**
   * Reads a format.
   *
   * @param text in the language of IPC; an empty one means that nothing is sent
   * @return what it says
   * @throws IpcFormatException where it is none; says where
   */
  public static IpcFormat parse(String text) throws IpcFormatException {
    if (text.length() > LONGEST) {
      throw new IpcFormatException("a format of " + text.length() + " characters is longer than any program's");
    }
    if (text.isBlank()) {
      return new IpcFormat.Nothing();
    }
    FormatText reader = new FormatText(text);
    IpcFormat format = reader.one();
    reader.blanks();
    if (reader.at < text.length()) {
      throw reader.wrong("nothing more");
    }
    return format;
  }

  private IpcFormat one() throws IpcFormatException {
    blanks();
    if (++depth > DEEPEST) {
      throw new IpcFormatException("a format has more than " + DEEPEST + " levels");
    }
    IpcFormat format = switch (peek()) {
      case '{' -> struct();
      case '*' -> pointer();
      case '[' -> fixed();
      case '<' -> variable();
      default -> word();
    };
    depth--;
    return format;
  }

  private IpcFormat struct() throws IpcFormatException {
    List<IpcFormat> members = new ArrayList<>();
    do {
      at++;
      members.add(one());
      blanks();
    } while (peek() == ',');
    take('}');
    return new IpcFormat.Struct(members);
  }

  private IpcFormat pointer() throws IpcFormatException {
    at++;
    return new IpcFormat.Pointer(one());
  }

  private IpcFormat fixed() throws IpcFormatException {
    at++;
    IpcFormat element = one();
    List<Integer> sizes = numbers();
    take(']');
    return new IpcFormat.FixedArray(element, sizes);
  }

  private IpcFormat variable() throws IpcFormatException {
    at++;
    IpcFormat element = one();
    List<Integer> members = numbers();
    take('>');
    return new IpcFormat.VariableArray(element, members);
  }

  private List<Integer> numbers() throws IpcFormatException {
    blanks();
    List<Integer> numbers = new ArrayList<>();
    take(':');
    numbers.add(number());
    while (peek() == ',') {
      at++;
      numbers.add(number());
    }
    return numbers;
  }

  private int number() throws IpcFormatException {
    blanks();
    String digits = letters();
    blanks();
    if (!digits.matches("[0-9]{1,9}")) {
      throw wrong("a number");
    }
    return Integer.parseInt(digits);
  }

  private IpcFormat word() throws IpcFormatException {
    String word = letters();
    if (word.isEmpty()) {
      throw wrong("a type");
    }
    if (word.matches("[0-9]{1,9}")) {
      return new IpcFormat.Opaque(Integer.parseInt(word));
    }
    Optional<IpcPrimitive> type = IpcPrimitive.named(word);
    return type.isPresent() ? new IpcFormat.Single(type.get()) : new IpcFormat.Named(word);
  }

  private String letters() {
    int begin = at;
    while (at < text.length() && (Character.isLetterOrDigit(text.charAt(at)) || text.charAt(at) == '_')) {
      at++;
    }
    return text.substring(begin, at);
  }

  private void take(char wanted) throws IpcFormatException {
    blanks();
    if (peek() != wanted) {
      throw wrong("'" + wanted + "'");
    }
    at++;
  }

  private char peek() {
    return at < text.length() ? text.charAt(at) : '\0';
  }

  private void blanks() {
    while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
      at++;
    }
  }

  private IpcFormatException wrong(String expected) {
    String near = at < text.length() ? "'" + text.substring(at, Math.min(text.length(), at + 12)) + "'" : "its end";
    return new IpcFormatException("a format has " + near + " at character " + (at + 1) + " where " + expected
        + " was expected");
  }
}
