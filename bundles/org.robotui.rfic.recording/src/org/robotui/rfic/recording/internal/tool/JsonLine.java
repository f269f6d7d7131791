package org.robotui.rfic.recording.internal.tool;

/** JSON in one line, put together from left to right. */
final class JsonLine {

  private final StringBuilder text = new StringBuilder();

  JsonLine open(char bracket) {
    separate();
    text.append(bracket);
    return this;
  }

  JsonLine close(char bracket) {
    text.append(bracket);
    return this;
  }

  JsonLine name(String name) {
    text(name);
    text.append(':');
    return this;
  }

  JsonLine text(String value) {
    separate();
    text.append('"');
    value.chars().forEach(this::character);
    text.append('"');
    return this;
  }

  /** A number, true or false. */
  JsonLine word(String value) {
    separate();
    text.append(value);
    return this;
  }

  private void character(int c) {
    if (c == '"' || c == '\\') {
      text.append('\\').append((char) c);
    } else if (c < ' ' || c >= 0x7f) {
      text.append(String.format("\\u%04x", c));
    } else {
      text.append((char) c);
    }
  }

  private void separate() {
    char last = text.isEmpty() ? '{' : text.charAt(text.length() - 1);
    if (last != '{' && last != '[' && last != ':') {
      text.append(',');
    }
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
