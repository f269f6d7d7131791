package org.robotui.message;

import java.util.Optional;

/** Finds definitions by type name. */
@FunctionalInterface
public interface DefinitionSource {

  /**
   * Finds one definition.
   *
   * @param type the full name, such as {@code std_msgs/Header}
   * @return empty if this source does not have it
   * @throws DefinitionException if it is there and broken
   */
  Optional<MessageDefinition> find(String type) throws DefinitionException;
}
