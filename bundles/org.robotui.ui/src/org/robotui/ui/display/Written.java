package org.robotui.ui.display;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.api.config.Settings;

/** Groups as they come out of settings: read from a file they are settings, set by the user they are maps. */
public final class Written {
  private Written() {}

  /**
   * The fields of a group.
   *
   * @param group settings, a map, or something else that has none
   * @return values by name, in the order written; the caller's own
   */
  public static Map<String, Object> fields(Object group) {
    Map<String, Object> fields = new LinkedHashMap<>();
    Map<?, ?> values = group instanceof Settings s ? s.values() : group instanceof Map<?, ?> m ? m : Map.of();
    values.forEach((name, value) -> fields.put(name.toString(), value));
    return fields;
  }

  /**
   * A text.
   *
   * @param fields of a group
   * @param name of the field
   * @return the text, empty where there is none
   */
  public static String text(Map<String, Object> fields, String name) {
    return fields.getOrDefault(name, "").toString();
  }

  /**
   * A flag.
   *
   * @param fields of a group
   * @param name of the field
   * @param otherwise where there is none
   * @return the flag
   */
  public static boolean flag(Map<String, Object> fields, String name, boolean otherwise) {
    return fields.get(name) instanceof Boolean b ? b : otherwise;
  }

  /**
   * A number.
   *
   * @param fields of a group
   * @param name of the field
   * @param otherwise where there is none
   * @return the number
   */
  public static double number(Map<String, Object> fields, String name, double otherwise) {
    return fields.get(name) instanceof Number n ? n.doubleValue() : otherwise;
  }

  static List<String> texts(Object value) {
    return value instanceof List<?> list ? list.stream().map(Object::toString).toList()
        : value.toString().isBlank() ? List.of() : List.of(value.toString());
  }
}
