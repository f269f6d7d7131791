package org.robotui.core.internal.config;

import org.robotui.api.config.Placed;
import org.robotui.api.config.Printable;
import org.robotui.api.host.Problem;

/**
 * A place in a file.
 *
 * @param file as the user named it
 * @param line from 1
 * @param column from 1
 * @param robot for which a template that stands there was formed, empty outside of templates
 */
record Place(String file, int line, int column, String robot) {
  private static final int LONGEST = 2000;

  Place(String file, int line, int column) {
    this(file, line, column, "");
  }

  /** Where a value stands, in what was formed for a robot of a template. */
  static Place of(Placed value, String robot) {
    return new Place(value.file(), value.line(), value.column(), robot);
  }

  Object at(Object value) {
    return new Placed(value, file, line, column);
  }

  Problem error(String message) {
    return problem(Problem.Severity.ERROR, message);
  }

  Problem warning(String message) {
    return problem(Problem.Severity.WARNING, message);
  }

  /** Messages quote what is written, and lists of valid words can be long. */
  private Problem problem(Problem.Severity severity, String message) {
    return new Problem(file, line, column, severity, Printable.beginning(message, LONGEST) + Repeated.of(robot));
  }
}
