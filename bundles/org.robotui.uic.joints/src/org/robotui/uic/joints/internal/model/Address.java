package org.robotui.uic.joints.internal.model;

import java.util.Optional;

/** The addresses of values, as other views take them: {@code base.joint_states:position[3]}. */
public final class Address {
  private Address() {}

  /** The address of what a column shows; of columns without a value of their own, that of the position. */
  public static Optional<String> of(JointRow row, JointColumn column) {
    String field = switch (column) {
      case VELOCITY -> "velocity";
      case EFFORT -> "effort";
      default -> "position";
    };
    return row.index().isPresent()
        ? Optional.of(row.source() + ":" + row.fields().path(field, row.index().getAsInt()))
        : Optional.empty();
  }
}
