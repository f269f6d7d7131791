package org.robotui.ros.reconfigure;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The values of a server's parameters at one moment.
 *
 * @param values by parameter name, in the order in which they came
 * @param groups whether a group is on, by its number
 */
public record ConfigValues(Map<String, ConfigValue> values, Map<Integer, Boolean> groups) {

  /** Copies the maps. */
  public ConfigValues {
    values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
    groups = Map.copyOf(groups);
  }
}
