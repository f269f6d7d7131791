package org.robotui.data.record;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A record out of named values.
 *
 * @param schema the name of its type
 * @param values the values in the order of the fields
 */
public record MapRecord(String schema, Map<String, FieldValue> values) implements DynamicRecord {
  /**
   * Copies the values.
   *
   * @param schema the name of its type
   * @param values the values
   */
  public MapRecord {
    values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
  }

  @Override
  public List<String> fields() {
    return List.copyOf(values.keySet());
  }

  @Override
  public Optional<FieldValue> field(String name) {
    return Optional.ofNullable(values.get(name));
  }
}
