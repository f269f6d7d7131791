package org.robotui.core.internal.config;

import org.robotui.api.host.Problem;

/**
 * A place in a file.
 *
 * @param file as the user named it
 * @param line from 1
 * @param column from 1
 */
record Place(String file, int line, int column) {
  Problem error(String message) {
    return new Problem(file, line, column, Problem.Severity.ERROR, message);
  }

  Problem warning(String message) {
    return new Problem(file, line, column, Problem.Severity.WARNING, message);
  }
}
