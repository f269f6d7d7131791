package org.robotui.uic.joints.internal.model;

import java.util.Optional;

/** Where values lie in the messages that they come from, as other views take them: {@code position[3]}. */
public final class Address {
  private Address() {}

  /** The field of what a column shows; of columns without a value of their own, that of the position. */
  public static Optional<String> field(JointRow row, JointColumn column) {
    String field = switch (column) {
      case VELOCITY -> "velocity";
      case EFFORT -> "effort";
      default -> "position";
    };
    return row.index().isPresent() ? Optional.of(row.fields().path(field, row.index().getAsInt())) : Optional.empty();
  }
}
