package org.robotui.uic.joints.internal.model;

import org.robotui.ui.Figures;

/** What a joint's position is measured in. The messages of robots do not say it; only the configuration can. */
public enum JointUnit {
  /** Rotary. */
  RADIANS("rad"),
  /** Prismatic. */
  METRES("m"),
  /** Not configured. */
  UNKNOWN("rad or m");

  private final String words;

  JointUnit(String words) {
    this.words = words;
  }

  /** The unit of positions, as users read it. */
  public String words() {
    return words;
  }

  /** The unit that a word of the configuration names. */
  public static JointUnit of(String word) {
    return word.equals(METRES.words) ? METRES : RADIANS;
  }

  /** A position; joints of unknown kind are taken as rotary where degrees are wanted, which the heading says. */
  public String position(double value, boolean degrees) {
    if (degrees && this != METRES) {
      return Figures.degrees(value, 1);
    }
    return figure(value, this == METRES ? 4 : 3, this == UNKNOWN ? "" : words);
  }

  /** A velocity. */
  public String velocity(double value, boolean degrees) {
    if (degrees && this != METRES) {
      return figure(Math.toDegrees(value), 1, "\u00b0/s");
    }
    return figure(value, this == METRES ? 4 : 3, this == UNKNOWN ? "" : words + "/s");
  }

  /** An effort. */
  public String effort(double value) {
    return figure(value, 2, switch (this) {
      case RADIANS -> "N\u00b7m";
      case METRES -> "N";
      case UNKNOWN -> "";
    });
  }

  private static String figure(double value, int decimals, String unit) {
    return Double.isNaN(value) ? Figures.UNKNOWN : Figures.of(value, decimals, unit);
  }
}
