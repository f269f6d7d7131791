package org.robotui.message;

import java.util.List;

/**
 * One message type as its definition says it, without the types it refers to.
 *
 * @param type the full name, such as {@code nav_msgs/Odometry}
 * @param text the definition's text as found, comments included
 * @param constants in the order of the text
 * @param fields in the order of the text, which is the order on the wire
 */
public record MessageDefinition(
    String type, String text, List<ConstantDefinition> constants, List<FieldDefinition> fields) {

  /** Keeps copies of the lists. */
  public MessageDefinition {
    constants = List.copyOf(constants);
    fields = List.copyOf(fields);
  }

  /**
   * The package part of the type's name.
   *
   * @return such as {@code nav_msgs}
   */
  public String packageName() {
    return type.substring(0, Math.max(0, type.indexOf('/')));
  }
}
