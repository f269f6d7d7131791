package org.robotui.uic.diagnostics.internal.model;

import org.robotui.data.status.Diagnostics;

/** How a part is, from best to worst: what does not report may be broken, so it is worse than a warning. */
public enum Level {
  /** Nothing is known. */
  UNKNOWN("unknown"),
  /** As it should be. */
  OK("OK"),
  /** Worth a look. */
  WARNING("Warning"),
  /** Has not reported for too long. */
  STALE("Stale"),
  /** Does not work. */
  ERROR("Error");

  private static final Level[] ALL = values();

  private final String word;

  Level(String word) {
    this.word = word;
  }

  /** The word that users read. */
  public String word() {
    return word;
  }

  /** Whether somebody should look. */
  public boolean problem() {
    return compareTo(OK) > 0;
  }

  /** The worse of this and another. */
  public Level worse(Level other) {
    return compareTo(other) >= 0 ? this : other;
  }

  static Level of(Diagnostics.Level level) {
    return switch (level) {
      case OK -> OK;
      case WARNING -> WARNING;
      case ERROR -> ERROR;
      case STALE -> STALE;
    };
  }

  static Level of(byte ordinal) {
    return ALL[ordinal];
  }
}
