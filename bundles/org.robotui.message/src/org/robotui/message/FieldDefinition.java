package org.robotui.message;

import java.util.Optional;

/**
 * One field of a message definition.
 *
 * @param type the type, with message types by their full name
 * @param name the name
 * @param initial the default as written, which senders give the field where nobody says otherwise
 */
public record FieldDefinition(FieldType type, String name, Optional<String> initial) {

  /**
   * A field without a default.
   *
   * @param type the type, with message types by their full name
   * @param name the name
   */
  public FieldDefinition(FieldType type, String name) {
    this(type, name, Optional.empty());
  }
}
