package org.robotui.api.config;

/**
 * A setting that fits its schema and is wrong all the same.
 *
 * @param file where it is written; empty where it stands in no file
 * @param line from 1, 0 where it stands in no file
 * @param column from 1, 0 where it stands in no file
 * @param message what was found, what was expected, and what to write
 */
public record SettingFault(String file, int line, int column, String message) {
  /** As compilers write it. */
  @Override
  public String toString() {
    return file.isEmpty() ? message : file + ":" + line + ":" + column + ": " + message;
  }
}
