package org.robotui.api.host;

import java.nio.file.Path;

/** What a file will hold, or why nothing can be written. */
public sealed interface CompositionText {
  /**
   * What is written, or was.
   *
   * @param file where
   * @param whole all of the file
   * @param added the part that is new
   * @param line where that part begins, from 1
   * @param isNew whether the file is not there yet
   */
  record Text(Path file, String whole, String added, int line, boolean isNew) implements CompositionText {}

  /**
   * Nothing can be written like this.
   *
   * @param field what has to be changed
   * @param reason what is wrong with it, and what to write
   */
  record Refused(Field field, String reason) implements CompositionText {}

  /** What a user says. */
  enum Field {
    /** The name. */
    NAME,
    /** The type of RUIC, its views and their connections. */
    VIEWS,
    /** The file. */
    FILE,
    /** The robot interface. */
    ROBOT
  }
}
