package org.robotui.data.internal;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/** Merging by key that keeps the order in which keys were first seen, so that views do not jump. */
public final class Merge {
  private Merge() {}

  public static <K, V> List<V> byKey(List<V> older, List<V> newer, Function<V, K> key) {
    Map<K, V> merged = new LinkedHashMap<>();
    older.forEach(v -> merged.put(key.apply(v), v));
    newer.forEach(v -> merged.put(key.apply(v), v));
    return List.copyOf(merged.values());
  }

  public static <V> List<V> last(List<V> values, int most) {
    return values.subList(Math.max(0, values.size() - most), values.size());
  }
}
