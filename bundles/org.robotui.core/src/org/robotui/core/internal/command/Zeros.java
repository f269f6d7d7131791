package org.robotui.core.internal.command;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Optional;
import org.robotui.data.Data;
import org.robotui.data.command.Motion;

/** Finds the command that stops. */
final class Zeros {
  private Zeros() {}

  /** The zero of a type of which no command was seen yet: its public constant {@code ZERO}. */
  static <T extends Data> Optional<T> of(Class<T> type) {
    try {
      Field field = type.getField("ZERO");
      boolean constant = Modifier.isStatic(field.getModifiers()) && type.isAssignableFrom(field.getType());
      return constant ? Optional.of(type.cast(field.get(null))) : Optional.empty();
    } catch (NoSuchFieldException | IllegalAccessException e) {
      return Optional.empty();
    }
  }

  /** The zero of a command; nothing where it moves nothing. */
  @SuppressWarnings("unchecked") // a Motion's zero is of its own type by contract
  static <T extends Data> Optional<T> of(T command) {
    return command instanceof Motion<?> motion ? Optional.of((T) motion.stopped()) : Optional.empty();
  }
}
