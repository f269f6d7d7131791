package org.robotui.api.host;

/**
 * Something wrong with a configuration.
 *
 * @param file where
 * @param line from 1, 0 where it concerns the whole file
 * @param column from 1
 * @param severity whether the configuration can be used all the same
 * @param message what was found, what was expected, and what to write
 */
public record Problem(String file, int line, int column, Severity severity, String message) {
  /** How bad. */
  public enum Severity {
    /** The RUIC cannot be started as written. */
    ERROR,
    /** It can, but hardly as meant. */
    WARNING
  }

  @Override
  public String toString() {
    return file + ":" + line + ":" + column + ": " + message;
  }
}
