package org.robotui.api.config;

import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.regex.Pattern;

/**
 * What a text must be like: its syntax, which is judged without an instance and without a robot. A text of a
 * configuration never has control characters, and is never longer than {@link #LONGEST}, whatever its rule.
 *
 * @param expected what is expected, with an example, as it stands behind "must be"
 * @param fault why a text is not like that; an empty reason where there is nothing to add, nothing where it fits. Never
 * throws
 */
public record TextRule(String expected, Function<String, Optional<String>> fault) {
  /** The most characters of a text. */
  public static final int LONGEST = 4096;

  /** Any text. */
  public static final TextRule ANY = matching("a text", "(?s).*");

  /** A host: a name, or an address of IPv4 or IPv6. */
  public static final TextRule HOST = matching("the name or address of a host, such as robot.local or 10.0.0.1",
      "[A-Za-z0-9_]([A-Za-z0-9._-]{0,252}[A-Za-z0-9_])?|\\[?[0-9A-Fa-f:.]*:[0-9A-Fa-f:.]*(%[A-Za-z0-9]+)?]?");

  /**
   * A coordinate frame: {@code map}, or {@code robot/map}. Robots choose these names, so that little is known of them.
   */
  public static final TextRule FRAME =
      matching("the name of a frame, such as map or Natalie/map", "[^\\s](.{0,510}[^\\s])?");

  /** A port of a component: the id of the component, a dot, and the name of the port. */
  public static final TextRule SOURCE =
      matching("a port of a component, such as base.odom", "[A-Za-z_][A-Za-z0-9_-]*\\..+");

  /**
   * Checks the parts.
   *
   * @param expected what is expected
   * @param fault why a text is not like that
   */
  public TextRule {
    Objects.requireNonNull(expected, "expected");
    Objects.requireNonNull(fault, "fault");
  }

  /**
   * Texts of a form.
   *
   * @param expected what is expected
   * @param regex what the whole text must match; one that takes long for some texts is no good one
   * @return the rule
   */
  public static TextRule matching(String expected, String regex) {
    Pattern pattern = Pattern.compile(regex);
    return new TextRule(expected, text -> pattern.matcher(text).matches() ? Optional.empty() : Optional.of(""));
  }

  /**
   * Texts that something can read.
   *
   * @param expected what is expected
   * @param reader throws {@link IllegalArgumentException}, with a reason for users, for what it cannot read
   * @return the rule
   */
  public static TextRule readBy(String expected, Consumer<String> reader) {
    return new TextRule(expected, text -> {
      try {
        reader.accept(text);
        return Optional.empty();
      } catch (IllegalArgumentException e) {
        return Optional.of(Optional.ofNullable(e.getMessage()).orElse(""));
      }
    });
  }

  /**
   * The same, or nothing.
   *
   * @param meaning what it means to write nothing, as in {@code "" for none}
   * @return a rule that takes an empty text as well
   */
  public TextRule orEmpty(String meaning) {
    return new TextRule(expected + ", or " + meaning, text -> text.isEmpty() ? Optional.empty() : fault.apply(text));
  }
}
