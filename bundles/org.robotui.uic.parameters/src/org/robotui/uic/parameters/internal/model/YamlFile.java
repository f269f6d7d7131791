package org.robotui.uic.parameters.internal.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Parameters as a YAML file, nested as their names are, so that the robot's own tools can load it. Pure. */
final class YamlFile {
  private YamlFile() {}

  /** The text of the file; names are relative to the namespace. */
  static String of(String namespace, Map<String, Object> values) {
    Map<String, Object> root = new LinkedHashMap<>();
    values.forEach((name, value) -> put(root, name.substring(namespace.length()), value));
    StringBuilder text =
        new StringBuilder("# ").append(values.size()).append(values.size() == 1 ? " parameter" : " parameters")
            .append(" of ").append(namespace.isEmpty() ? "/" : namespace).append('\n');
    write(text, root, 0);
    return text.toString();
  }

  private static void put(Map<String, Object> root, String path, Object value) {
    Map<String, Object> at = root;
    List<String> parts = path.isEmpty() ? List.of("value") : Branch.parts(path);
    for (String part : parts.subList(0, parts.size() - 1)) {
      at = inner(at, part);
    }
    at.put(parts.getLast(), value);
  }

  private static Map<String, Object> inner(Map<String, Object> at, String part) {
    if (!(at.get(part) instanceof Space space)) {
      Space made = new Space();
      at.put(part, made);
      return made.inner;
    }
    return space.inner;
  }

  private static void write(StringBuilder text, Map<String, Object> space, int depth) {
    space.forEach((name, value) -> {
      text.append("  ".repeat(depth)).append(ValueText.quoted(name)).append(':');
      if (value instanceof Space inner) {
        text.append('\n');
        write(text, inner.inner, depth + 1);
      } else {
        text.append(' ').append(ValueText.nested(value)).append('\n');
      }
    });
  }

  /** A namespace, which is no value. */
  private static final class Space {
    private final Map<String, Object> inner = new LinkedHashMap<>();
  }
}
