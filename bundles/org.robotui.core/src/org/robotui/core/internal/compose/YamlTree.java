package org.robotui.core.internal.compose;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;

/**
 * What a YAML text says, whatever its style: to be compared. Maps, lists, and scalars as texts; a section of nothing
 * and nothing are the same.
 */
final class YamlTree {
  private static final int DEEPEST = 40;
  private static final String NOTHING = "plain ";

  private YamlTree() {}

  static Object of(String yaml) {
    return of(new MarkedText(yaml));
  }

  static Object of(MarkedText yaml) {
    return yaml.root().map(node -> of(node, 0)).orElse(NOTHING);
  }

  private static Object of(Node node, int depth) {
    if (depth > DEEPEST) {
      throw new YAMLException("too deep");
    }
    return switch (node) {
      case ScalarNode s -> isNothing(s) ? NOTHING : (s.isPlain() ? "plain " : "quoted ") + s.getValue();
      case SequenceNode s -> s.getValue().stream().map(item -> of(item, depth + 1)).toList();
      case MappingNode m -> section(m, depth);
      default -> throw new YAMLException("unexpected " + node.getNodeId());
    };
  }

  private static Object section(MappingNode node, int depth) {
    Map<String, Object> values = new LinkedHashMap<>();
    node.getValue().forEach(t -> values.put(key(t.getKeyNode()), of(t.getValueNode(), depth + 1)));
    return values.isEmpty() ? NOTHING : values;
  }

  private static String key(Node node) {
    return node instanceof ScalarNode s ? s.getValue() : node.toString();
  }

  static boolean isNothing(Node node) {
    return node instanceof ScalarNode s && s.isPlain() && List.of("", "~", "null").contains(s.getValue());
  }

  /** What stands at a path. */
  static Object at(Object tree, List<String> path) {
    Object at = tree;
    for (String name : path) {
      at = switch (at) {
        case Map<?, ?> map when map.get(name) != null -> map.get(name);
        case List<?> list -> list.get(Integer.parseInt(name));
        default -> NOTHING;
      };
    }
    return at;
  }

  private static Object withItem(List<?> list, List<String> path, Optional<Object> value) {
    List<Object> changed = new ArrayList<>(list);
    int place = Integer.parseInt(path.getFirst());
    if (place >= list.size()) {
      return list;
    }
    if (path.size() == 1 && value.isEmpty()) {
      changed.remove(place);
    } else {
      changed.set(place, with(list.get(place), path.subList(1, path.size()), value));
    }
    return changed;
  }

  /** The same with another value at a path, or without one. */
  static Object with(Object tree, List<String> path, Optional<Object> value) {
    if (path.isEmpty()) {
      return value.orElseThrow();
    }
    if (tree instanceof List<?> list) {
      return withItem(list, path, value);
    }
    Map<String, Object> changed = new LinkedHashMap<>();
    if (tree instanceof Map<?, ?> map) {
      map.forEach((name, part) -> changed.put(name.toString(), part));
    } else if (!NOTHING.equals(tree)) {
      changed.put(PathEdit.TYPE, tree);
    }
    String name = path.getFirst();
    if (value.isEmpty() && !changed.containsKey(name)) {
      return tree;
    }
    if (path.size() == 1 && value.isEmpty()) {
      changed.remove(name);
    } else {
      changed.put(name,
          with(changed.getOrDefault(name, NOTHING), path.subList(1, path.size()), value));
    }
    return changed.isEmpty() ? NOTHING : changed;
  }
}
