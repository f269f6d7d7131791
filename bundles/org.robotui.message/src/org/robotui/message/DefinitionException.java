package org.robotui.message;

/** A message or service definition that cannot be used: says which type, which line and why. */
public final class DefinitionException extends Exception {

  private static final long serialVersionUID = 1L;

  /**
   * Creates the error for a whole type.
   *
   * @param type the type's name
   * @param problem what is wrong
   */
  public DefinitionException(String type, String problem) {
    super("definition of " + type + ": " + problem);
  }

  /**
   * Creates the error for one line.
   *
   * @param type the type's name
   * @param line the line's number, from 1
   * @param problem what is wrong
   */
  public DefinitionException(String type, int line, String problem) {
    super("definition of " + type + ", line " + line + ": " + problem);
  }
}
