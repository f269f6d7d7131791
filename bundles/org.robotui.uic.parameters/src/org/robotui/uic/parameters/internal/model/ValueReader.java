package org.robotui.uic.parameters.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Reads a value that was typed, of the kind that the parameter has: a number stays a number, a list of numbers too. */
public final class ValueReader {
  private static final int HEX = 16;

  private ValueReader() {}

  /**
   * Reads.
   *
   * @param typed what was typed
   * @param like the value that it replaces
   * @return a value of the same kind
   * @throws Unreadable where it is none
   */
  public static Object read(String typed, Object like) throws Unreadable {
    String text = typed.strip();
    return switch (like) {
      case String s -> typed;
      case Boolean b -> flag(text);
      case Long l -> whole(text);
      case Double d -> real(text);
      case List<?> list -> listLike(list, FlowParser.parse(text));
      case Map<?, ?> map -> mapLike(map, FlowParser.parse(text));
      default -> throw new Unreadable("Values of this kind cannot be edited");
    };
  }

  static Boolean flag(String text) throws Unreadable {
    return switch (text.toLowerCase(Locale.ROOT)) {
      case "true", "yes", "on", "1" -> Boolean.TRUE;
      case "false", "no", "off", "0" -> Boolean.FALSE;
      default -> throw new Unreadable("Write true or false; '" + text + "' is neither");
    };
  }

  static Long whole(String text) throws Unreadable {
    try {
      return text.startsWith("0x") ? Long.parseLong(text.substring(2), HEX) : Long.parseLong(text);
    } catch (NumberFormatException e) {
      throw new Unreadable("'" + text + "' is no whole number");
    }
  }

  static Double real(String text) throws Unreadable {
    switch (text.toLowerCase(Locale.ROOT)) {
      case "nan", ".nan" :
        return Double.NaN;
      case "inf", ".inf", "+.inf" :
        return Double.POSITIVE_INFINITY;
      case "-inf", "-.inf" :
        return Double.NEGATIVE_INFINITY;
      default :
        return finite(text);
    }
  }

  private static Double finite(String text) throws Unreadable {
    boolean suffixed = text.endsWith("d") || text.endsWith("f") || text.endsWith("D") || text.endsWith("F");
    try {
      double value = Double.parseDouble(suffixed ? "?" : text);
      if (Double.isInfinite(value)) {
        throw new Unreadable("'" + text + "' is too large");
      }
      return value;
    } catch (NumberFormatException e) {
      throw new Unreadable("'" + text + "' is no number" + (text.contains(",") ? "; decimals begin with a point" : ""));
    }
  }

  private static List<?> listLike(List<?> like, Object read) throws Unreadable {
    if (!(read instanceof List<?> list)) {
      throw new Unreadable("Write a list, for example [1, 2, 3]");
    }
    boolean reals = !like.isEmpty() && like.stream().allMatch(Double.class::isInstance);
    List<Object> values = new ArrayList<>();
    for (int i = 0; i < list.size(); i++) {
      Object value = list.get(i);
      values.add(reals && value instanceof Long whole ? Double.valueOf(whole)
          : i < like.size() ? nestedLike(like.get(i), value) : value);
    }
    return values;
  }

  private static Map<?, ?> mapLike(Map<?, ?> like, Object read) throws Unreadable {
    if (!(read instanceof Map<?, ?> map)) {
      throw new Unreadable("Write a map, for example {x: 1, y: 2}");
    }
    Map<String, Object> values = new LinkedHashMap<>();
    for (Map.Entry<?, ?> entry : map.entrySet()) {
      Object before = like.get(entry.getKey());
      values.put(entry.getKey().toString(), before == null ? entry.getValue() : nestedLike(before, entry.getValue()));
    }
    return values;
  }

  /** Within lists and maps kinds may change, but a number that had decimals keeps them. */
  private static Object nestedLike(Object like, Object value) throws Unreadable {
    if (like instanceof Double && value instanceof Long whole) {
      return Double.valueOf(whole);
    }
    if (like instanceof List<?> list && value instanceof List<?>) {
      return listLike(list, value);
    }
    return like instanceof Map<?, ?> map && value instanceof Map<?, ?> ? mapLike(map, value) : value;
  }
}
