package org.robotui.api.config;

import java.nio.file.Path;

/**
 * A value together with where it is written, for components that can only judge it later, or that read files relative
 * to the one in which they are named. See {@link ValueType.WithPlace}.
 *
 * @param value Boolean, Long, Double, String, List or Map, as its type says
 * @param file the configuration file as the user named it; empty for a value that stands in no file
 * @param line from 1, 0 for a value that stands in no file
 * @param column from 1, 0 for a value that stands in no file
 */
public record Placed(Object value, String file, int line, int column) {
  /**
   * A value that stands in no file.
   *
   * @param value the value
   * @return the value without a place
   */
  public static Placed nowhere(Object value) {
    return new Placed(value, "", 0, 0);
  }

  /**
   * A file or folder that this value names.
   *
   * @param name absolute, or relative to the folder of the configuration file
   * @return where it is
   * @throws java.nio.file.InvalidPathException where the name is none of a file
   */
  public Path resolve(String name) {
    return file.isEmpty() ? Path.of(name) : Path.of(file).toAbsolutePath().resolveSibling(name).normalize();
  }

  /**
   * Something wrong with the value.
   *
   * @param message what was found, what was expected, and what to write
   * @return the fault, at this place
   */
  public SettingFault fault(String message) {
    return new SettingFault(file, line, column, message);
  }
}
