package org.robotui.ros2.parameter;

import java.util.Map;
import java.util.Set;
import org.robotui.ros2.name.Ros2Name;

/**
 * Parameters of a node that changed.
 *
 * @param node whose
 * @param values those that are new or have another value, by name
 * @param deleted the names of those that are gone
 */
public record Ros2ParameterEvent(Ros2Name node, Map<String, Ros2ParameterValue> values, Set<String> deleted) {

  /** Copies the collections. */
  public Ros2ParameterEvent {
    values = Map.copyOf(values);
    deleted = Set.copyOf(deleted);
  }
}
