package org.robotui.data.sensor;

import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;
import org.robotui.data.internal.Check;

/**
 * A position on the earth, WGS 84.
 *
 * @param frame frame of the antenna
 * @param quality what kind of fix it is
 * @param latitude radians, north is positive; NaN without a fix
 * @param longitude radians, east is positive; NaN without a fix
 * @param altitude metres above the ellipsoid, NaN where unknown
 * @param horizontalAccuracy one standard deviation, metres, NaN where unknown
 */
public record GpsFix(
    FrameId frame, Quality quality, double latitude, double longitude, double altitude, double horizontalAccuracy)
    implements Data, InFrame {
  /** What kind of fix. */
  public enum Quality {
    /** None. */
    NO_FIX,
    /** Unaugmented. */
    FIX,
    /** With satellite based augmentation. */
    SATELLITE_AUGMENTED,
    /** With ground based augmentation. */
    GROUND_AUGMENTED
  }

  /**
   * Checks the range of a fix.
   *
   * @param frame the frame
   * @param quality the quality
   * @param latitude radians
   * @param longitude radians
   * @param altitude metres
   * @param horizontalAccuracy metres
   */
  public GpsFix {
    Check.that(!(Math.abs(latitude) > Math.PI / 2 + 1e-9), "latitude", "must be within a quarter turn, is " + latitude);
    Check.that(!(Math.abs(longitude) > 2 * Math.PI), "longitude", "must be within a full turn, is " + longitude);
    Check.that(!(Math.abs(altitude) > Check.FARTHEST), "altitude",
        "must be within " + Check.FARTHEST + " m, is " + altitude);
  }
}
