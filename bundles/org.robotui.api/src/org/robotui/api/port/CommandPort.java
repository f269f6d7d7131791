package org.robotui.api.port;

import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.data.command.Motion;

/**
 * A port for commands into a robot.
 *
 * @param <T> the type of the commands
 * @param name unique within the component
 * @param type what a robot interface accepts, or a view produces
 * @param arity how many connections a view takes
 * @param help a sentence for users
 */
public record CommandPort<T extends Data>(String name, Class<T> type, Arity arity, String help) implements Port {
  @Override
  public PortKind kind() {
    return PortKind.COMMAND;
  }

  @Override
  public String typeName() {
    return DataType.of(type).name();
  }

  /**
   * Tells whether its commands keep something moving: then stop sends their zero here.
   *
   * @return true for types that are a {@link Motion}
   */
  public boolean isMotion() {
    return Motion.class.isAssignableFrom(type);
  }
}
