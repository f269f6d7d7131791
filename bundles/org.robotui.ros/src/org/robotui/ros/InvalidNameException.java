package org.robotui.ros;

/** A text that is no ROS graph name; the message says which rule it breaks. */
public final class InvalidNameException extends IllegalArgumentException {

  private static final long serialVersionUID = 1L;

  /**
   * Creates the error.
   *
   * @param name the text
   * @param rule what a valid name looks like at the place where this one does not
   */
  public InvalidNameException(String name, String rule) {
    super("'" + name + "' is no valid ROS name: " + rule);
  }
}
