package org.robotui.api.script;

import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.StreamSupport;

/** Writes lines of scripts. */
public final class ScriptLine {
  private static final long EXACT = 1L << 53;

  private ScriptLine() {}

  /**
   * The call of a function.
   *
   * @param function its name
   * @param arguments each a text, a number or a truth value
   * @return for example {@code openView("map", "Natalie");}
   */
  public static String call(String function, Object... arguments) {
    return Arrays.stream(arguments).map(ScriptLine::literal).collect(Collectors.joining(", ", function + "(", ");"));
  }

  /**
   * A value as it is written in a script.
   *
   * @param value a text, a number, a truth value, or several of them
   * @return texts in quotes, with all that is not plain ASCII as an escape
   */
  public static String literal(Object value) {
    return switch (value) {
      case Iterable<?> several -> StreamSupport.stream(several.spliterator(), false)
          .map(ScriptLine::literal).collect(Collectors.joining(", ", "[", "]"));
      case Boolean flag -> flag.toString();
      case Number number -> number(number.doubleValue());
      default -> quoted(value.toString());
    };
  }

  private static String number(double value) {
    boolean whole = value == Math.rint(value) && Math.abs(value) < EXACT;
    return whole ? Long.toString((long) value) : Double.toString(value);
  }

  private static String quoted(String text) {
    return text.chars()
        .mapToObj(c -> c < ' ' || c > '~' || c == '"' || c == '\\' ? "\\u%04x".formatted(c) : Character.toString(c))
        .collect(Collectors.joining("", "\"", "\""));
  }
}
