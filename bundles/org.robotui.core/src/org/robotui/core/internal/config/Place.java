package org.robotui.core.internal.config;

import org.robotui.api.config.Placed;
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
  Place(String file, int line, int column) {
    this(file, line, column, "");
  }

  Object at(Object value) {
    return new Placed(value, file, line, column);
  }

  Problem error(String message) {
    return new Problem(file, line, column, Problem.Severity.ERROR, message + Repeated.of(robot));
  }

  Problem warning(String message) {
    return new Problem(file, line, column, Problem.Severity.WARNING, message + Repeated.of(robot));
  }
}
