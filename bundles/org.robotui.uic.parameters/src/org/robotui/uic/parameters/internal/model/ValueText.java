package org.robotui.uic.parameters.internal.model;

import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Values of parameters as text in one line, as YAML writes them. Pure. */
public final class ValueText {
  private static final Pattern PLAIN = Pattern.compile("[A-Za-z_/$(][\\w/.$() -]*");
  private static final Pattern WORD = Pattern.compile("(?i)true|false|null|yes|no|on|off|y|n|nan|inf|infinity");

  private ValueText() {}

  /** A value as it is shown and edited: a text as it is, all else as YAML. */
  public static String of(Object value) {
    return value instanceof String text ? text : nested(value);
  }

  /** A value within another. */
  static String nested(Object value) {
    return switch (value) {
      case String text -> quoted(text);
      case List<?> list -> list.stream().map(ValueText::nested).collect(Collectors.joining(", ", "[", "]"));
      case Map<?, ?> map -> map.entrySet().stream()
          .map(entry -> quoted(entry.getKey().toString()) + ": " + nested(entry.getValue()))
          .collect(Collectors.joining(", ", "{", "}"));
      case Double number -> number(number);
      default -> value.toString();
    };
  }

  /** The name of a value's kind. */
  public static String type(Object value) {
    return switch (value) {
      case Boolean b -> "bool";
      case Long l -> "int";
      case Double d -> "double";
      case String s -> "string";
      case List<?> list -> "list of " + list.size();
      case Map<?, ?> map -> "map of " + map.size();
      default -> value.getClass().getSimpleName();
    };
  }

  static String quoted(String text) {
    boolean plain = PLAIN.matcher(text).matches() && !WORD.matcher(text).matches() && text.equals(text.strip())
        && !text.contains(": ");
    return plain ? text
        : '"' + text.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n").replace("\t", "\\t").replace("\r",
            "\\r") + '"';
  }

  private static String number(double number) {
    if (Double.isNaN(number)) {
      return ".nan";
    }
    return Double.isInfinite(number) ? number > 0 ? ".inf" : "-.inf" : Double.toString(number);
  }
}
