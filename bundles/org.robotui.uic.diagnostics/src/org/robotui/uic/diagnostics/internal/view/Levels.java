package org.robotui.uic.diagnostics.internal.view;

import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.uic.diagnostics.internal.model.Level;

/** How levels look. */
final class Levels {
  private Levels() {}

  static Health health(Level level) {
    return switch (level) {
      case UNKNOWN -> Health.NONE;
      case OK -> Health.OK;
      case WARNING -> Health.WARNING;
      case STALE -> Health.STALE;
      case ERROR -> Health.BAD;
    };
  }

  static Role role(Level level) {
    return level == Level.STALE ? Role.DIM : health(level).role();
  }

  /** How high a level stands in a strip, so that it is known without its colour. */
  static double height(Level level) {
    return switch (level) {
      case UNKNOWN -> 0;
      case OK -> 0.3;
      case WARNING -> 0.65;
      case STALE -> 0.5;
      case ERROR -> 1;
    };
  }
}
