package org.robotui.urdf;

/**
 * Something wrong in a text.
 *
 * @param line from 1; 0 where it concerns all of it
 * @param message what is wrong, and what is to be written
 */
public record Problem(int line, String message) {
  @Override
  public String toString() {
    return line > 0 ? "line " + line + ": " + message : message;
  }
}
