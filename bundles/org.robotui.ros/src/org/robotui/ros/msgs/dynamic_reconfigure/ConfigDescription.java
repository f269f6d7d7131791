package org.robotui.ros.msgs.dynamic_reconfigure;

import java.util.List;

import org.robotui.message.MessageType;

/**
 * Describes all parameters of a server ({@code dynamic_reconfigure/ConfigDescription}).
 *
 * @param groups the parameters, in groups
 * @param max highest values
 * @param min lowest values
 * @param dflt values at the start
 */
@MessageType("dynamic_reconfigure/ConfigDescription")
public record ConfigDescription(List<Group> groups, Config max, Config min, Config dflt) {

  /** Keeps immutable copies of lists. */
  public ConfigDescription {
    groups = List.copyOf(groups);
  }
}
