package org.robotui.uic.parameters.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.api.input.TypedText;
import org.robotui.api.input.Unreadable;

/** Reads a value that was typed, of the kind that the parameter has: a number stays a number, a list of numbers too. */
public final class ValueReader {
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
      case Boolean b -> named(text, TypedText::flag);
      case Long l -> named(text, TypedText::whole);
      case Double d -> named(text, TypedText::real);
      case List<?> list -> listLike(list, FlowParser.parse(text));
      case Map<?, ?> map -> mapLike(map, FlowParser.parse(text));
      default -> throw new Unreadable("Values of this kind cannot be edited");
    };
  }

  private static Object named(String text, Reading reading) throws Unreadable {
    try {
      return reading.read(text);
    } catch (Unreadable e) {
      throw new Unreadable("'" + text + "' " + e.getMessage());
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

  /** How one value is read. */
  private interface Reading {
    Object read(String text) throws Unreadable;
  }
}
