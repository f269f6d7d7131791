package org.robotui.ros.reconfigure;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The choices of a parameter: {@code {'enum': [{'name': ..., 'value': ..., 'description': ...}], 'enum_description':
 * ...}}.
 */
record EditMethod(List<ConfigChoice> choices, String description) {

  private static final Logger LOG = LoggerFactory.getLogger(EditMethod.class);
  private static final EditMethod NONE = new EditMethod(List.of(), "");

  /** Reads what a server wrote; a text that is no such dictionary is as none: then the parameter takes any value. */
  static EditMethod read(String text, ConfigKind kind) {
    if (text.isBlank()) {
      return NONE;
    }
    try {
      return PythonLiteral.parse(text) instanceof Map<?, ?> map ? read(map, kind) : NONE;
    } catch (PythonLiteral.SyntaxException e) {
      LOG.debug("edit_method ignored: {}", e.getMessage());
      return NONE;
    }
  }

  private static EditMethod read(Map<?, ?> map, ConfigKind kind) {
    if (!(map.get("enum") instanceof List<?> list)) {
      return NONE;
    }
    List<ConfigChoice> choices = list.stream().filter(Map.class::isInstance)
        .flatMap(each -> choice((Map<?, ?>) each, kind).stream()).toList();
    return new EditMethod(choices, text(map.get("enum_description")));
  }

  private static Optional<ConfigChoice> choice(Map<?, ?> map, ConfigKind kind) {
    return Optional.<Object>ofNullable(map.get("value")).flatMap(value -> ConfigValue.of(kind, value))
        .map(value -> new ConfigChoice(text(map.get("name")), value, text(map.get("description"))));
  }

  private static String text(Object value) {
    return value instanceof String text ? text : "";
  }
}
