package org.robotui.core.internal.config;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.yaml.snakeyaml.DumperOptions;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.representer.Representer;

/** Values of YAML that the product has written itself, read with care: users mend such files by hand. */
final class KeptYaml {
  private static final int MAX_DEPTH = 150;

  private KeptYaml() {}

  static String text(Object value) {
    return yaml().dump(value);
  }

  /** Reads a text. Throws a YAMLException where it is none, or is nested without an end. */
  static Object value(String text) {
    Object root = yaml().load(text);
    bounded(root, 0);
    return root == null ? Map.of() : root;
  }

  /** An alias of something that it is part of would be followed for ever. */
  private static void bounded(Object value, int depth) {
    if (depth > MAX_DEPTH) {
      throw new YAMLException("it is nested too deeply");
    }
    switch (value) {
      case Map<?, ?> map -> map.values().forEach(v -> bounded(v, depth + 1));
      case List<?> list -> list.forEach(v -> bounded(v, depth + 1));
      case null, default -> {}
    }
  }

  /** A map with texts as keys; what is empty counts as nothing. */
  static Map<String, Object> map(Object value) {
    if (value == null || "".equals(value)) {
      return Map.of();
    }
    if (!(value instanceof Map<?, ?> written)) {
      return refuse("a section", value);
    }
    Map<String, Object> copy = new LinkedHashMap<>();
    written.forEach((k, v) -> copy.put(String.valueOf(k), v == null ? "" : v));
    return copy;
  }

  /** A list; what is empty counts as nothing. */
  static List<Object> list(Object value) {
    if (value == null || "".equals(value)) {
      return List.of();
    }
    return value instanceof List<?> written ? written.stream().<Object>map(v -> v == null ? "" : v).toList()
        : refuse("a list", value);
  }

  /** YAML reads small numbers as Integer; settings hold Long. */
  static Map<String, Object> settings(Object value) {
    Map<String, Object> kept = new LinkedHashMap<>();
    map(value).forEach((name, v) -> kept.put(name, v instanceof Integer i ? (Object) i.longValue() : v));
    return kept;
  }

  static <T> T refuse(String expected, Object value) {
    throw new IllegalArgumentException("expected " + expected + ", not " + value.getClass().getSimpleName());
  }

  private static Yaml yaml() {
    DumperOptions options = new DumperOptions();
    options.setDefaultFlowStyle(DumperOptions.FlowStyle.BLOCK);
    LoaderOptions limits = new LoaderOptions();
    limits.setNestingDepthLimit(MAX_DEPTH);
    return new Yaml(new SafeConstructor(limits), new Representer(options), options, limits);
  }
}
