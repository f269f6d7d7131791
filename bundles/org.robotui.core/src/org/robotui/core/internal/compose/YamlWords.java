package org.robotui.core.internal.compose;

import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.robotui.api.config.ValueType;

/** Writes values as YAML, in one line, such that they are read as what they are. */
final class YamlWords {
  /** What is safe without quotes, also within braces and brackets. */
  private static final Pattern PLAIN =
      Pattern.compile("[A-Za-z0-9_./~][A-Za-z0-9_./@%+=*~:-]*(?: [A-Za-z0-9_./@%+=~-]+)*");
  private static final Pattern NUMBER = Pattern.compile("[-+]?(\\.[0-9]+|[0-9][0-9_]*(\\.[0-9]*)?)([eE][-+]?[0-9]+)?");
  private static final Pattern RESERVED = Pattern.compile("(?i)~|null|true|false|yes|no|on|off|none|y|n");

  private YamlWords() {}

  /** A text, such as a name or a port. */
  static String text(String text) {
    boolean plain = PLAIN.matcher(text).matches() && !text.endsWith(":") && !text.contains(": ")
        && !RESERVED.matcher(text).matches()
        && !NUMBER.matcher(text).matches();
    return plain ? text : quoted(text);
  }

  /** A value of a setting: Boolean, Number, String, List or Map, as forms and command lines give them. */
  static String value(Object value, ValueType type) {
    return switch (value) {
      case List<?> list -> list.stream().map(v -> value(v, element(type))).collect(Collectors.joining(", ", "[", "]"));
      case Map<?, ?> map -> map.entrySet().stream()
          .map(e -> text(e.getKey().toString()) + ": " + value(e.getValue(), member(type, e.getKey().toString(), map)))
          .collect(Collectors.joining(", ", "{", "}"));
      case String text -> takesText(type) || !NUMBER.matcher(text).matches() ? text(text) : text;
      default -> value.toString();
    };
  }

  private static boolean takesText(ValueType type) {
    return switch (type) {
      case ValueType.Text t -> true;
      case ValueType.Choice c -> true;
      case ValueType.AnyOf any -> any.alternatives().stream().anyMatch(YamlWords::takesText);
      case ValueType.WithPlace placed -> takesText(placed.value());
      default -> false;
    };
  }

  /** What the elements of a list hold. */
  static ValueType element(ValueType type) {
    return switch (type) {
      case ValueType.ListOf list -> list.element();
      case ValueType.WithPlace placed -> element(placed.value());
      case ValueType.AnyOf any -> any.alternatives().stream().filter(ValueType.ListOf.class::isInstance).findFirst()
          .map(YamlWords::element).orElse(type);
      default -> type;
    };
  }

  /** What an entry of a section holds; {@code group} is the section. */
  static ValueType member(ValueType type, String name, Map<?, ?> group) {
    ValueType declared = declared(type, name);
    return declared instanceof ValueType.Dependent dependent ? dependent.in(group) : declared;
  }

  private static ValueType declared(ValueType type, String name) {
    return switch (type) {
      case ValueType.MapOf map -> map.value();
      case ValueType.Section section -> section.schema().find(name).map(s -> s.type()).orElse(type);
      case ValueType.WithPlace placed -> declared(placed.value(), name);
      case ValueType.AnyOf any -> any.alternatives().stream()
          .filter(t -> t instanceof ValueType.MapOf || t instanceof ValueType.Section).findFirst()
          .map(t -> declared(t, name)).orElse(type);
      default -> type;
    };
  }

  private static String quoted(String text) {
    StringBuilder out = new StringBuilder("\"");
    text.codePoints().forEach(c -> {
      switch (c) {
        case '"' -> out.append("\\\"");
        case '\\' -> out.append("\\\\");
        case '\n' -> out.append("\\n");
        case '\t' -> out.append("\\t");
        default -> {
          if (c < ' ' || c == 0x7f) {
            out.append(String.format("\\x%02x", c));
          } else {
            out.appendCodePoint(c);
          }
        }
      }
    });
    return out.append('"').toString();
  }
}
