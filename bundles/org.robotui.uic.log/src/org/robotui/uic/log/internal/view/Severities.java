package org.robotui.uic.log.internal.view;

import java.util.Optional;
import org.robotui.data.status.Severity;
import org.robotui.ui.Health;
import org.robotui.ui.Role;

/** How severities look. */
final class Severities {
  private Severities() {}

  /** The dot, none for what needs no attention. */
  static Optional<Health> dot(Severity severity) {
    return switch (severity) {
      case DEBUG, INFO -> Optional.empty();
      case WARNING -> Optional.of(Health.WARNING);
      case ERROR, FATAL -> Optional.of(Health.BAD);
    };
  }

  static Role role(Severity severity) {
    return switch (severity) {
      case DEBUG, INFO -> Role.DIM;
      case WARNING -> Role.WARNING;
      case ERROR, FATAL -> Role.BAD;
    };
  }
}
