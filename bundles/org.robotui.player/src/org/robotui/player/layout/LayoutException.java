package org.robotui.player.layout;

/** A description of an interface that cannot be used, or a Java record that does not fit it. */
public final class LayoutException extends IllegalArgumentException {

  private static final long serialVersionUID = 1L;

  /**
   * Creates the error for one line.
   *
   * @param file the file's name
   * @param line the line's number, from 1
   * @param problem what is wrong
   */
  public LayoutException(String file, int line, String problem) {
    super(file + ", line " + line + ": " + problem);
  }

  /**
   * Creates the error for a Java record.
   *
   * @param problem what does not fit
   */
  public LayoutException(String problem) {
    super(problem);
  }
}
