package org.robotui.message.description;

import java.util.List;
import java.util.Objects;

/**
 * One described type, without those it refers to.
 *
 * @param typeName the name of three parts, such as {@code std_msgs/msg/Header}
 * @param fields in the order on the wire
 */
public record StructDescription(String typeName, List<FieldDescription> fields) {

  /** Copies the fields. */
  public StructDescription {
    Objects.requireNonNull(typeName, "typeName");
    fields = List.copyOf(fields);
  }
}
