package org.robotui.message;

import java.util.Optional;

/** A place where definitions of all kinds are found. It may read files at each question: not for I/O threads. */
public interface Definitions extends DefinitionSource {

  /**
   * The definitions that are part of this library.
   *
   * @param generation whose version of a type is meant
   * @return them, without reading files of this machine
   */
  static Definitions shipped(Generation generation) {
    return new ShippedDefinitions(generation);
  }

  /**
   * Finds a service.
   *
   * @param type the full name
   * @return empty if this place does not have it
   * @throws DefinitionException if it is there and broken
   */
  Optional<ServiceDefinition> service(String type) throws DefinitionException;

  /**
   * Finds an action of ROS 2.
   *
   * @param type the full name
   * @return empty if this place does not have it
   * @throws DefinitionException if it is there and broken
   */
  Optional<ActionDefinition> action(String type) throws DefinitionException;
}
