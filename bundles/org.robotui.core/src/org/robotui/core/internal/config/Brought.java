package org.robotui.core.internal.config;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.RuicType.UicSpec;

/**
 * The views that the type of a RUIC brings along.
 *
 * @param types the types of views by their ids
 * @param all false where there may be more, since the type is not installed now
 */
record Brought(Map<String, String> types, boolean all) {
  static Brought of(List<UicSpec> specs) {
    Map<String, String> types = new LinkedHashMap<>();
    specs.forEach(spec -> types.put(spec.id(), spec.type()));
    return new Brought(types, true);
  }

  Brought without(Collection<String> leftOut) {
    Map<String, String> left = new LinkedHashMap<>(types);
    left.keySet().removeAll(leftOut);
    return new Brought(left, all);
  }

  Known views() {
    return new Known(types.keySet(), all);
  }

  /** The type of a view, where it is known. */
  Optional<String> typeOf(String id) {
    return Optional.ofNullable(types.get(id));
  }
}
