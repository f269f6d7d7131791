package org.robotui.message.description;

import java.util.Objects;

/**
 * One field of a described type.
 *
 * @param name the field's name
 * @param typeId the number of its type by {@code type_description_interfaces/msg/FieldType}, see {@link FieldKind}
 * @param capacity the length of a fixed array or the bound of a sequence, else 0
 * @param stringCapacity the bound of a text, else 0
 * @param nestedTypeName the type of three parts that it nests, else empty
 * @param defaultValue what senders give it where nobody says otherwise, as written; not part of the sum
 */
public record FieldDescription(String name, int typeId, long capacity, long stringCapacity, String nestedTypeName,
    String defaultValue) {

  /** Checks that nothing is missing. */
  public FieldDescription {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(nestedTypeName, "nestedTypeName");
    Objects.requireNonNull(defaultValue, "defaultValue");
  }

  static FieldDescription nested(String name, TypeName type, int arity, long capacity) {
    return new FieldDescription(name, FieldKind.NESTED + arity, capacity, 0, type.toString(), "");
  }

  static FieldDescription nested(String name, TypeName type) {
    return nested(name, type, FieldKind.ONE, 0);
  }
}
