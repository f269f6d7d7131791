package org.robotui.ros.reconfigure;

import java.util.Optional;

/** What a parameter holds. */
public enum ConfigKind {

  /** A truth value. */
  FLAG("bool"),
  /** A 32-bit integer. */
  WHOLE("int"),
  /** A 64-bit float. */
  REAL("double"),
  /** A text. */
  TEXT("str");

  private final String type;

  ConfigKind(String type) {
    this.type = type;
  }

  /** The kind a description names. */
  static Optional<ConfigKind> of(String type) {
    for (ConfigKind kind : values()) {
      if (kind.type.equals(type)) {
        return Optional.of(kind);
      }
    }
    return Optional.empty();
  }
}
