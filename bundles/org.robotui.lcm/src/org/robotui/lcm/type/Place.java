package org.robotui.lcm.type;

/**
 * A place in a {@code .lcm} file.
 *
 * @param file the file as it was named
 * @param line from 1
 * @param column from 1
 */
public record Place(String file, int line, int column) {

  /** As compilers write places. */
  @Override
  public String toString() {
    return file + ":" + line + ":" + column;
  }
}
