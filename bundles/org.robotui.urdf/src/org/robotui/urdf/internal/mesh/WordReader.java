package org.robotui.urdf.internal.mesh;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.robotui.urdf.internal.Refusal;

/** The words of a text in bytes, one after the other. */
final class WordReader {
  private static final int LONGEST = 4096;

  private final byte[] bytes;
  private int at;
  private int line = 1;

  WordReader(byte[] bytes) {
    this.bytes = bytes;
  }

  int line() {
    return line;
  }

  Optional<String> next() {
    while (at < bytes.length && isBlank(bytes[at])) {
      line += bytes[at++] == '\n' ? 1 : 0;
    }
    return at == bytes.length ? Optional.empty() : Optional.of(word());
  }

  /** The next word of this line; none at its end. */
  Optional<String> nextInLine() {
    while (at < bytes.length && isBlank(bytes[at]) && bytes[at] != '\n') {
      at++;
    }
    return at == bytes.length || bytes[at] == '\n' ? Optional.empty() : Optional.of(word());
  }

  /** What is left of this line, without blanks around it. */
  String rest() {
    int start = at;
    while (at < bytes.length && bytes[at] != '\n') {
      at++;
    }
    return new String(bytes, start, Math.min(at - start, LONGEST), StandardCharsets.UTF_8).strip();
  }

  void skipLine() {
    while (at < bytes.length && bytes[at] != '\n') {
      at++;
    }
  }

  float number() throws Refusal {
    return number(next().orElse("the end"));
  }

  float number(String word) throws Refusal {
    try {
      return Float.parseFloat(word);
    } catch (NumberFormatException e) {
      throw new Refusal(line, "'" + word + "' is no number");
    }
  }

  private String word() {
    int start = at;
    while (at < bytes.length && !isBlank(bytes[at])) {
      at++;
    }
    return new String(bytes, start, Math.min(at - start, LONGEST), StandardCharsets.UTF_8);
  }

  private static boolean isBlank(byte b) {
    return b >= 0 && b <= ' ';
  }
}
