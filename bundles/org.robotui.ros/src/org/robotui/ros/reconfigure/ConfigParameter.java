package org.robotui.ros.reconfigure;

import java.util.List;
import java.util.Optional;

/**
 * A parameter a server offers.
 *
 * @param name its name, unique at the server
 * @param kind what it holds
 * @param description for a user; may be empty
 * @param level bits the server hears of when it changes, unsigned
 * @param min the lowest value of a number; empty if it has none
 * @param max the highest value of a number; empty if it has none
 * @param initial the value the server's author chose; empty if the server does not say
 * @param choices the values it is meant to have; empty if any
 * @param choicesDescription what the choice is about; may be empty
 */
public record ConfigParameter(String name, ConfigKind kind, String description, long level, Optional<ConfigValue> min,
    Optional<ConfigValue> max, Optional<ConfigValue> initial, List<ConfigChoice> choices, String choicesDescription) {

  /** Copies the choices. */
  public ConfigParameter {
    choices = List.copyOf(choices);
  }
}
