package org.robotui.message;

import java.util.ArrayList;
import java.util.List;

/** Values as definitions of ROS 2 write them. */
final class Literals {

  private Literals() {}

  /** The default of a field, in the form that messages are built from. */
  static Object value(FieldType type, String written) {
    String clean = written.strip();
    boolean text = type.primitive().filter(Primitive::isText).isPresent();
    if (!type.isArray()) {
      return text ? text(clean) : scalar(clean);
    }
    List<Object> values = new ArrayList<>();
    for (String each : elements(clean)) {
      values.add(text ? text(each) : scalar(each));
    }
    return values;
  }

  /** A text without its quotes; what follows the closing one is a comment. */
  static String text(String written) {
    String clean = written.strip();
    if (clean.isEmpty() || clean.charAt(0) != '"' && clean.charAt(0) != '\'') {
      return clean;
    }
    StringBuilder text = new StringBuilder();
    for (int i = 1; i < clean.length() && clean.charAt(i) != clean.charAt(0); i++) {
      boolean escape = clean.charAt(i) == '\\' && i + 1 < clean.length();
      i += escape ? 1 : 0;
      text.append(escape ? escaped(clean.charAt(i)) : clean.charAt(i));
    }
    return text.toString();
  }

  private static char escaped(char letter) {
    return switch (letter) {
      case 'n' -> '\n';
      case 't' -> '\t';
      default -> letter;
    };
  }

  /** Numbers are read by those who write them; only the words for bools differ, as ROS 2 takes 0 and 1 as well. */
  private static Object scalar(String written) {
    return switch (written) {
      case "0" -> 0L;
      case "1" -> 1L;
      default -> written;
    };
  }

  /** What stands between the brackets, divided by commas outside of quotes. */
  private static List<String> elements(String written) {
    int end = written.lastIndexOf(']');
    String inner = written.startsWith("[") && end > 0 ? written.substring(1, end) : written;
    List<String> elements = new ArrayList<>();
    StringBuilder element = new StringBuilder();
    char quote = 0;
    for (char each : inner.toCharArray()) {
      if (quote == 0 && each == ',') {
        elements.add(element.toString().strip());
        element.setLength(0);
        continue;
      }
      if (each == quote) {
        quote = 0;
      } else if (quote == 0 && (each == '"' || each == '\'')) {
        quote = each;
      }
      element.append(each);
    }
    if (!element.toString().isBlank()) {
      elements.add(element.toString().strip());
    }
    return elements;
  }
}
