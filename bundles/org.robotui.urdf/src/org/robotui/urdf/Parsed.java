package org.robotui.urdf;

import java.util.List;
import java.util.Optional;

/**
 * What came of reading a text.
 *
 * @param <T> what it describes
 */
public sealed interface Parsed<T> {
  /**
   * It was read.
   *
   * @param <T> what it describes
   * @param value what it says
   * @param warnings what was wrong but could be passed over
   */
  record Ok<T>(T value, List<Problem> warnings) implements Parsed<T> {
    /**
     * Copies the list.
     *
     * @param value what it says
     * @param warnings passed over
     */
    public Ok {
      warnings = List.copyOf(warnings);
    }
  }

  /**
   * It cannot be used.
   *
   * @param <T> what it should have described
   * @param problem the first thing that is wrong
   */
  record Refused<T>(Problem problem) implements Parsed<T> {}

  /**
   * What it says, where it was read.
   *
   * @return the value, or none
   */
  default Optional<T> found() {
    return this instanceof Ok<T>(T value, List<Problem> warnings) ? Optional.of(value) : Optional.empty();
  }
}
