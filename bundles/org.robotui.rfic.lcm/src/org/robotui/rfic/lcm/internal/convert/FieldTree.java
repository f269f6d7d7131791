package org.robotui.rfic.lcm.internal.convert;

import java.util.Collections;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.robotui.rfic.lcm.internal.language.MemberPath;

/**
 * Values by the paths of members. Elements of arrays are kept by their index: a {@link SortedMap} of {@link Integer}.
 */
final class FieldTree {
  private final Map<String, Object> root = new TreeMap<>();

  /** Puts a value at a path. */
  void put(MemberPath path, Object value) {
    Map<Object, Object> at = map(root);
    for (int i = 0; i < path.steps().size() - 1; i++) {
      boolean element = path.steps().get(i + 1) instanceof MemberPath.Step.Index;
      at = map(at.computeIfAbsent(key(path.steps().get(i)),
          k -> element ? new TreeMap<Integer, Object>() : new TreeMap<String, Object>()));
    }
    at.put(key(path.steps().getLast()), value);
  }

  private static Object key(MemberPath.Step step) {
    return switch (step) {
      case MemberPath.Step.Name n -> n.name();
      case MemberPath.Step.Index i -> i.index();
      case MemberPath.Step.All all -> throw new IllegalArgumentException(
          "a command fills in one element, not all: write its index into the []");
    };
  }

  @SuppressWarnings("unchecked")
  private static Map<Object, Object> map(Object value) {
    return (Map<Object, Object>) value;
  }

  Map<String, Object> fields() {
    return Collections.unmodifiableMap(root);
  }
}
