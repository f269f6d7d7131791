package org.robotui.entity.gps;

import org.robotui.data.sensor.GpsFix;
import org.robotui.ui.Role;

/** How the quality of a fix appears: in a word and a colour. */
public final class FixLook {
  private FixLook() {}

  /**
   * The word.
   *
   * @param quality of the fix
   * @return for example {@code SBAS fix}
   */
  public static String word(GpsFix.Quality quality) {
    return switch (quality) {
      case NO_FIX -> "no fix";
      case FIX -> "GPS fix";
      case SATELLITE_AUGMENTED -> "SBAS fix";
      case GROUND_AUGMENTED -> "GBAS fix";
    };
  }

  /**
   * The colour.
   *
   * @param quality of the fix
   * @return its role
   */
  public static Role role(GpsFix.Quality quality) {
    return switch (quality) {
      case NO_FIX -> Role.BAD;
      case FIX -> Role.WARNING;
      case SATELLITE_AUGMENTED -> Role.ACCENT;
      case GROUND_AUGMENTED -> Role.GOOD;
    };
  }
}
